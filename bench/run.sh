#!/usr/bin/env bash
# Makes every number of docs/performance.md: some twenty minutes on an idle machine.
#     bench/run.sh [FOLDER OF PEERS] [FOLDER OF POINTS]     results in out/; both folders default to those beside the project
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
peers=${1:-../shared/peers} points=${2:-../shared/data/points}
mkdir -p out
cmake -S . -B build -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build build -j 2 --target gmds_command handwritten_delaunay handwritten_delaunay3 >/dev/null
options=()
if [ -f "$peers/Makefile" ]; then
  for peer in cgal_delaunay cgal_homology gudhi_homology; do
    make -s -C "$peers" OUT="$PWD/out/peers" "$PWD/out/peers/$peer"
  done
  options=(--peers out/peers)
fi
specs=(random:1000:1 random:10000:1 random:100000:1 clusters:1000000:1 circle:200000)
for name in pdal_autzen_trim_lidar.xyz.xz gmt_ship_15.xyz.xz geonames_cities1000_lonlat.xy.xz cgal_norway_coast_endpoints.xy.xz; do
  [ -f "$points/$name" ] && specs+=("$points/$name")
done
bench/delaunay.py --runs 15 "${options[@]}" random:1000000:1 grid:1000 >out/delaunay.json
bench/delaunay.py --runs 9 "${options[@]}" "${specs[@]}" >>out/delaunay.json
bench/delaunay.py --runs 5 random:1000000:1 random:10000000:1 >out/ten-million.json
space=(random:1000:1 random:10000:1 random:100000:1 clusters:1000000:1)
for name in pdal_autzen_trim_lidar.xyz.xz gmt_ship_15.xyz.xz cgal_kitten.xyz.xz; do
  [ -f "$points/$name" ] && space+=("$points/$name")
done
bench/delaunay.py --dim 3 --runs 9 "${options[@]}" random:1000000:1 grid:100 "${space[@]}" >out/delaunay3.json
bench/tables.py <out/delaunay3.json >out/delaunay3.md
bench/tables.py <out/delaunay.json >out/delaunay.md
bench/tables.py <out/ten-million.json >out/ten-million.md
build/bin/gmds bench predicates --json >out/predicates.json
for model in 'N|E|F|N2E|N2F|E2N|E2F|F2N|F2E|F2F' 'N|F|N2F|F2N|F2F' 'N|F|F2N|F2F' 'N|F|F2N'; do
  build/bin/gmds bench cells --n 500 --model "$model" --json
done >out/cells.json
/usr/bin/python3 bench/models.py >out/models.txt
/usr/bin/python3 bench/models.py --dim 3 --out out/models3 >out/models3.txt
surfaces=(torus:200 torus:700 torus:1300)
for name in bff_kitten.obj derived_lobsterCT_tri.off simnibs_fsaverage_lh_sphere.off surfice_BrainMesh_Ch2.off vtkdata_turbineblade.ply; do
  [ -f "$points/../surfaces/$name.xz" ] && surfaces+=("$points/../surfaces/$name.xz")
done
/usr/bin/python3 bench/homology.py --runs 7 "${options[@]}" "${surfaces[@]}"
echo "out/: delaunay.md, delaunay3.md, ten-million.md, cells.json, predicates.json, models.txt, models/, models3.txt, models3/, homology/"
