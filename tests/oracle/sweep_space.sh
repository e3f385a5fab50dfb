#!/usr/bin/env bash
# Every model of volumes of the command against CGAL's checksums: sweep_space.sh GMDS FOLDER_OF_THIS
# The small inputs of expected3.txt on the 64 models that take every path and on the named ones.
set -eu
gmds=$1 here=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$here"
sweeps=0
while read -r points sum; do
  case $points in
    '#'* | random:5*000:* | grid:12 | grid:30 | clusters:5000:3) continue ;;
  esac
  for models in paths named; do
    "$gmds" sweep --dim 3 --points "$points" --models "$models" --expect "$sum" --jobs 2 >"$scratch/table" || {
      echo "$points: not every model gives CGAL's cells"
      grep -v ' ok$' "$scratch/table"
      exit 1
    }
    sweeps=$((sweeps + 1))
    echo "$points: $(tail -n 1 "$scratch/table")"
  done
done <expected3.txt
[ "$sweeps" -gt 0 ]
