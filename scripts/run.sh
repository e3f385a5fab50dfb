#!/usr/bin/env bash
# Sets up, builds, and triangulates the same points with every model, in the plane and in space, each compared with CGAL:
#     scripts/run.sh [POINTS]      POINTS: random:1225:1 unless given; see `gmds sweep --help`
# In space the 64 models that take every path have random:200:1 to do, the named ones random:2000:1. The tables go to the
# screen and to out/sweep.csv, out/paths.csv, out/named.csv, pictures beside them. Succeeds when every model does.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/bootstrap.sh
. scripts/bootstrap.sh
points=${1:-random:1225:1}

bootstrap run
cmake -S . -B build -DCMAKE_BUILD_TYPE=Release -DGMDS_BUILD_TOOLS=ON -DGMDS_BUILD_TESTS=ON
cmake --build build --target gmds_command -j "$(jobs_at_once)"

oracle=
if cmake --build build --target help | grep oracle_delaunay2 >/dev/null; then
  cmake --build build --target oracle_delaunay2 oracle_delaunay3
  oracle=yes
fi

# sweep DIM POINTS MODELS NAME: one table, compared with CGAL's checksum where that is known
sweep() {
  local sum expect=()
  if [ -n "$oracle" ]; then
    sum=$("build/bin/oracle_delaunay$1" "$2")
    say "CGAL's triangulation of $2 in dimension $1 has the checksum $sum"
  else
    sum=$(awk -v spec="$2" '$1 == spec { print $2 }' "tests/oracle/expected$1.txt")
    say "CGAL was not found; elsewhere it gave the checksum ${sum:-of other points only}"
  fi
  if [ -n "$sum" ]; then
    expect=(--expect "$sum")
  fi
  if build/bin/gmds sweep --dim "$1" --points "$2" --models "$3" ${expect[@]+"${expect[@]}"} \
    --csv "out/$4.csv" --plot "out/$4.svg"; then
    say "the table is in out/$4.csv, its picture in out/$4.svg"
  else
    say "the sweep failed"
    status=1
  fi
}

mkdir -p out
status=0
sweep 2 "$points" all sweep
sweep 3 random:200:1 paths paths
sweep 3 random:2000:1 named named
exit "$status"
