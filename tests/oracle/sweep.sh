#!/usr/bin/env bash
# Every model of the command against CGAL's checksums: sweep.sh small|large GMDS FOLDER_OF_THIS [ORACLE FOLDER_OF_POINTS]
#   small  the inputs of expected2.txt with at most 1300 points, and point files with at most 2500, on all models
#   large  the larger point files, on every model that answers all queries locally
# Point files need the oracle; without it only expected2.txt is used.
set -eu
mode=$1 gmds=$2 here=$3 oracle=${4:-} folder=${5:-}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$here"
sweeps=0

sweep() { # POINTS SUM MODELS
  "$gmds" sweep --points "$1" --models "$3" --expect "$2" >"$scratch/table" || {
    echo "$1: not every model gives CGAL's triangles"
    grep -v ' ok$' "$scratch/table"
    exit 1
  }
  sweeps=$((sweeps + 1))
  echo "$1: $(tail -n 1 "$scratch/table")"
}

complete=$("$gmds" models --dim 2 --csv | awk -F, '$2 == 1 && $6 == 1 { print $1 }' | paste -sd,)

if [ "$mode" = small ]; then
  while read -r points sum; do
    case $points in
      '#'* | grid:100 | random:20000:7 | clusters:5000:3) ;;
      *) sweep "$points" "$sum" all ;;
    esac
  done <expected2.txt
fi

if [ -n "$oracle" ] && [ -n "$folder" ]; then
  for file in "$folder"/*.xy "$folder"/*.xyz "$folder"/*.xy.xz "$folder"/*.xyz.xz; do
    [ -e "$file" ] || continue
    points=$scratch/$(basename "$file" .xz)
    case $file in
      *.xz) xz -dc "$file" >"$points" ;;
      *) cp "$file" "$points" ;;
    esac
    n=$(grep -cv '^ *#' "$points")
    if [ "$mode" = small ] && [ "$n" -le 2500 ]; then
      sweep "$points" "$("$oracle" "$points")" all
    elif [ "$mode" = large ] && [ "$n" -gt 2500 ]; then
      sweep "$points" "$("$oracle" "$points")" "$complete,N|F|F2N|F2F"
    fi
    rm -f "$points"
  done
else
  echo "skipped, no oracle or no folder of point files: real point sets"
fi
[ "$sweeps" -gt 0 ]
