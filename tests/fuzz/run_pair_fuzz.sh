#!/bin/sh
# tests/fuzz/run_pair_fuzz.sh [CASES] [SEED]: CASES (10^7 by default) random and adversarial pairs through every method and
# pair of kinds, two processes. A broken rule leaves its case in build/release/pair_fuzz, for `dem contact`. Many hours.
set -eu
cd "$(dirname "$0")/../.."
cmake --preset release
cmake --build --preset release --target pair_fuzz
fuzz="build/release/bin/pair_fuzz build/release/pair_fuzz ${2:-1} ${1:-10000000}"
$fuzz 0/2 &
status=0
$fuzz 1/2 || status=1
wait $! || status=1
exit $status
