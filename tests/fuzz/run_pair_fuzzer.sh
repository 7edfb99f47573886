#!/bin/sh
# tests/fuzz/run_pair_fuzzer.sh [SECONDS]: coverage-guided fuzzing of pairs with libFuzzer and the address and
# undefined-behaviour sanitizers, by default for ten minutes. Needs clang with its run-time library (Debian: clang-16
# libclang-rt-16-dev). A failure leaves its bytes in build/fuzzer and prints the case for `dem contact`.
set -eu
cd "$(dirname "$0")/../.."
cmake -S . -B build/fuzzer -DCMAKE_CXX_COMPILER="${CXX:-clang++-16}" -DCMAKE_BUILD_TYPE=Release -DPROJECT_FUZZER=ON
cmake --build build/fuzzer --target pair_fuzzer -j 2
cd build/fuzzer
mkdir -p corpus
exec bin/pair_fuzzer -max_total_time="${1:-600}" -max_len=1024 corpus
