#!/usr/bin/env bash
# Every mask of the census of volumes that identifies its cells, 5856 of them, tetrahedra and all standard types in turn,
# against brute force: exhaustive.sh CC SOURCE BUILD CHOOSE LIBRARY SCRATCH [FIRST LAST]
# Compiled in chunks of 64 models, each run and deleted before the next, two at once. FIRST and LAST pick chunks from 0.
# Not part of the usual run of tests: ctest -C exhaustive -L exhaustive. The 92 chunks take 71
# minutes of a processor; there are never more than two on the disk, 100 MB.
set -eu
cc=$1 source=$2 build=$3 choose=$4 library=$5 scratch=$6 first=${7:-0} last=${8:-}
files_a_chunk=8
rm -rf "$scratch"
mkdir -p "$scratch/all"
trap 'rm -rf "$scratch"' EXIT
"$choose" "$scratch/all" all
mapfile -t files <"$scratch/all/files.txt"
chunks=$(((${#files[@]} + files_a_chunk - 1) / files_a_chunk))
last=${last:-$((chunks - 1))}
flags=(-std=c17 -O0 -w -ffp-contract=off -pthread -DTEST_DELAUNAY=0 "-I$source/tests" "-I$source/include" "-I$build/include")

for part in reference subject pool exhaustive; do
  "$cc" "${flags[@]}" -O2 -c "$source/tests/volumes/$part.c" -o "$scratch/$part.o"
done
cat >"$scratch/full.c" <<'EOF'
#include "volumes/volume.h"
#define GMDS_PREFIX full
#define GMDS_MODEL (N|E|F|R|N2N|N2E|N2F|N2R|E2N|E2E|E2F|E2R|F2N|F2E|F2F|F2R|R2N|R2E|R2F|R2R)
#define GMDS_REGIONS (TETRAHEDRON|PYRAMID|PRISM|HEXAHEDRON)
#include <gmds/mesh.h>
#include "volumes/table.h"
#include <gmds/end.h>
EOF
"$cc" "${flags[@]}" -c "$scratch/full.c" -o "$scratch/full.o"

run_chunk() {
  local folder=$scratch/$1 file objects=()
  mkdir "$folder"
  for file in "${files[@]:$(($1 * files_a_chunk)):$files_a_chunk}"; do
    "$cc" "${flags[@]}" -c "$scratch/all/$file" -o "$folder/$file.o" || return 1
    sed -n 's/^#define GMDS_PREFIX \(.*\)$/X(\1_table)/p' "$scratch/all/$file" >>"$folder/list.h"
    objects+=("$folder/$file.o")
  done
  echo 'X(full_table)' >>"$folder/list.h"
  "$cc" "${flags[@]}" "-I$folder" -c "$source/tests/volumes/list.c" -o "$folder/list.o" || return 1
  # shellcheck disable=SC2086 # several libraries
  "$cc" -pthread "${objects[@]}" "$folder/list.o" "$scratch"/{full,reference,subject,pool,exhaustive}.o $library \
    -o "$folder/run" || return 1
  CK_FORK=no "$folder/run" >"$folder/said" 2>&1 || {
    echo "chunk $1 of $chunks:"
    cat "$folder/said"
    return 1
  }
  echo "chunk $1 of $chunks: $(grep models "$folder/said")"
  rm -r "$folder"
}

failed=0
for ((chunk = first; chunk <= last; chunk += 2)); do
  run_chunk "$chunk" &
  other=$!
  if [ $((chunk + 1)) -le "$last" ]; then
    run_chunk $((chunk + 1)) || failed=1
  fi
  wait "$other" || failed=1
done
exit "$failed"
