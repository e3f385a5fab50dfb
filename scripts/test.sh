#!/usr/bin/env bash
# Sets up, builds, and runs every test; then the quick ones again under the address and undefined-behaviour sanitizers, and
# those of several threads under the thread sanitizer.
#     scripts/test.sh [ARGUMENTS OF CTEST]      for instance: scripts/test.sh -R delaunay
# GMDS_WERROR=ON makes warnings errors; GMDS_DATA_DIR names a folder of real meshes and point sets.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/bootstrap.sh
. scripts/bootstrap.sh
bootstrap tests
jobs=$(jobs_at_once)
options=(-DGMDS_WERROR="${GMDS_WERROR:-OFF}")
if [ -n "${GMDS_DATA_DIR:-}" ]; then
  options+=(-DGMDS_DATA_DIR="$GMDS_DATA_DIR")
fi

cmake -S . -B build -DCMAKE_BUILD_TYPE=Release "${options[@]}"
cmake --build build -j "$jobs"
ctest --test-dir build -j "$jobs" --output-on-failure "$@"

say "the quick tests once more, under sanitizers"
# (without the command: its 114 models take long to compile so; test_delaunay and test_queries cover their parts)
cmake --preset asan "${options[@]}" -DGMDS_BUILD_TOOLS=OFF
cmake --build build-asan -j "$jobs"
ctest --test-dir build-asan -j "$jobs" --output-on-failure -LE '^(slow|install|compile)$' "$@"

say "the tests of several threads once more, under the thread sanitizer"
cmake --preset tsan "${options[@]}" -DGMDS_BUILD_TOOLS=OFF
cmake --build build-tsan -j "$jobs" --target threads_tests
ctest --test-dir build-tsan -j "$jobs" --output-on-failure -L '^threads$' "$@"
