#!/usr/bin/env bash
# Sets up, builds, and triangulates the same points with every model, each compared with CGAL:
#     scripts/run.sh [POINTS]      POINTS: random:1225:1 unless given; see `gmds sweep --help`
# The table goes to the screen, out/sweep.csv and out/sweep.svg. Succeeds when every model does.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/bootstrap.sh
. scripts/bootstrap.sh
points=${1:-random:1225:1}

bootstrap run
cmake -S . -B build -DCMAKE_BUILD_TYPE=Release -DGMDS_BUILD_TOOLS=ON -DGMDS_BUILD_TESTS=ON
cmake --build build --target gmds_command -j "$(jobs_at_once)"

expect=()
if cmake --build build --target help | grep oracle_delaunay2 >/dev/null; then
  cmake --build build --target oracle_delaunay2
  sum=$(build/bin/oracle_delaunay2 "$points")
  say "CGAL's triangles of $points have the checksum $sum"
else
  sum=$(awk -v spec="$points" '$1 == spec { print $2 }' tests/oracle/expected.txt)
  say "CGAL was not found; elsewhere it gave the checksum ${sum:-of other points only}"
fi
if [ -n "$sum" ]; then
  expect=(--expect "$sum")
fi

mkdir -p out
status=0
build/bin/gmds sweep --points "$points" --models all ${expect[@]+"${expect[@]}"} \
  --csv out/sweep.csv --plot out/sweep.svg || status=$?
if [ "$status" = 0 ]; then
  say "the table is in out/sweep.csv, its picture in out/sweep.svg"
else
  say "the sweep failed"
fi
exit "$status"
