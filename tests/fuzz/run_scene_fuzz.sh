#!/bin/sh
# tests/fuzz/run_scene_fuzz.sh [SECONDS] [SEED]: builds with address and undefined-behaviour sanitizers and fuzzes scenes,
# by default for ten minutes. A crash leaves its scene in build/sanitize/scene_fuzz/case.toml.
set -eu
cd "$(dirname "$0")/../.."
cmake --preset sanitize
cmake --build --preset sanitize --target scene_fuzz
export ASAN_OPTIONS="${ASAN_OPTIONS:-hard_rss_limit_mb=4000:detect_stack_use_after_return=1}"
exec build/sanitize/bin/scene_fuzz build/sanitize/scene_fuzz "${2:-1}" 1000000000 "${1:-600}"
