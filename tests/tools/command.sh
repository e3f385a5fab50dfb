#!/usr/bin/env bash
# Claims about the command: command.sh PATH_OF_GMDS. Prints each claim that fails; exits 1 if any does.
set -u
gmds=$1
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir" || exit 1
failures=0
claims=0

fail() { echo "FAILED: $*"; failures=$((failures + 1)); }

# run CODE ARGUMENTS...: runs the command, keeps out and err, and claims the exit code; failures say one sentence.
run() {
  local code=$1
  shift
  claims=$((claims + 1))
  "$gmds" "$@" >out 2>err
  local got=$?
  [ "$got" = "$code" ] || fail "gmds $*: exit $got, expected $code: $(cat err)"
  if [ "$code" != 0 ] && [ "$(wc -l <err)" != 1 ]; then fail "gmds $*: not one sentence: $(cat err)"; fi
}
says() { grep -q -e "$1" err || fail "expected '$1' on stderr, found: $(cat err)"; }
prints() { grep -q -e "$1" out || fail "expected '$1' on stdout, found: $(head -c 400 out)"; }
absent() { [ ! -e "$1" ] || fail "$1 exists"; }
empty_of_leftovers() { [ -z "$(find . -name '*.tmp*' -o -name '.*.gmds*' | head -1)" ] || fail "left behind: $(ls -A)"; }

# ---- help and wrong usage
run 0 --help && prints 'sweep'
run 0 --version
for verb in models sweep delaunay homology convert info check bench; do run 0 "$verb" --help && prints "usage: gmds $verb"; done
run 2 nonsense && says "no verb 'nonsense'"
run 2 delaunay && says 'missing'
run 2 delaunay a b && says 'too many'
run 2 delaunay --bogus x && says "no option '--bogus'"
run 2 delaunay random:10:1 -o && says 'lacks its value'
run 2 delaunay random:10:1 --dim 4
run 2 delaunay random:10:1 --threads 0
run 2 delaunay random:10:1 --threads 5000 && says '4096'
run 2 models --dim 5
run 2 sweep --expect 123 && says "16 hexadecimal digits in lower case, not '123'"
run 2 sweep --expect 0123456789ABCDEF && says 'lower case'
run 2 sweep --dim 3 --expect "$(printf '0123456789abcdef\n0123456789abcdef')" && says 'one checksum'
run 2 sweep --jobs zero
run 2 models --csv=1
run 2 sweep --plot x.png
run 2 sweep --plot x.svg --csv x.svg
run 2 info --dim 4 x.off

# ---- models: the census
run 0 models --dim 2 --csv
[ "$(wc -l <out)" = 129 ] || fail "the census of dimension 2 has $(wc -l <out) lines"
[ "$(head -1 out)" = "model,computable,identified,paper105,full,complete,cost_0_0,cost_0_1,cost_0_2,cost_1_0,cost_1_1,cost_1_2,cost_2_0,cost_2_1,cost_2_2" ] || fail "census header: $(head -1 out)"
[ "$(awk -F, 'NR>1{s+=$2} END{print s}' out)" = 114 ] || fail "computable"
[ "$(awk -F, 'NR>1{s+=$3} END{print s}' out)" = 96 ] || fail "identified"
[ "$(awk -F, 'NR>1{s+=$4} END{print s}' out)" = 105 ] || fail "paper105"
run 0 models --dim 3 --csv
[ "$(awk -F, 'NR>1{s+=$2} END{print s}' out)" = 7854 ] || fail "computable in 3D"
[ "$(awk -F, 'NR>1{s+=$3} END{print s}' out)" = 5856 ] || fail "identified in 3D"
run 0 models cmap && prints '3-map that keeps nodes: [0-9]* bytes a dart'
run 0 models 'N|F|F2N|F2F' && prints 'direct matrix' && prints '0 -> 2  global' && prints 'traversal of F2N'
run 0 models 'N|E|F|R|N2E|E2N|E2F|F2E|F2R|R2F' && prints '2 2 x 2'
run 0 models R1 && prints 'model N|R|N2R|R2N'
for name in F1 F2 F3 F4 F5 F6 R1 R2 R3 R4; do run 0 models --dim 3 $name --csv && prints '^N|.*R2'; done
run 1 models --dim 2 R1 && says 'R1'
run 1 models 'N|F|F2X' && says "'F2X'"
run 1 models 'N||F' && says 'no cell'

# ---- delaunay
run 0 delaunay grid:35 --json && prints '"checksum":"ddcec7cabf7fc153"' && prints '"cells":2312' && prints '"dimension":2'
for key in points duplicates dimension cells seconds bytes peak_bytes checksum; do prints "\"$key\":"; done

# in space
run 0 delaunay grid:5 --dim 3 --json && prints '"checksum":"cadefdadc5a6697d"' && prints '"dimension":3'
run 0 delaunay random:200:1 --dim 3 --model F1 -o space.vtu --json && prints '"cells":1135' && prints '"checksum":"1177d45ff9316f8c"'
run 0 delaunay random:50000:3 --dim 3 --threads 2 --json && prints '"checksum":"e71ae898895be8ec"'
run 0 delaunay random:5000:7 --dim 3 --model R2 --threads 8 --json && prints '"checksum":"9f2ef49cc3256c3b"' # takes one
run 0 info space.vtu && prints tetrahedron
run 0 delaunay random:200:1 --dim 3 --model 'N|R|R2N|R2R' -o space.msh
run 0 delaunay circle:300 --dim 3 --json && prints '"dimension":2' && prints '"checksum":"3041764ae6bc7903"'
run 0 sweep --dim 3 --points random:50:1 && prints '11 of 11 models ok'
run 0 sweep --dim 3 --points random:20:1 --models paths --csv space.csv && prints '64 of 64 models ok'
[ "$(wc -l <space.csv)" = 65 ] || fail "the sweep of paths has $(wc -l <space.csv) lines"
run 0 sweep --dim 3 --points random:20:1 --models 'R1,N|R|R2N,F4' && prints '3 of 3 models ok'
run 1 sweep --dim 3 --points random:20:1 --models 'N|F|F2N' && says 'keeps no regions: add R'
run 1 sweep --dim 3 --points random:20:1 --models 'N|R|N2F' && says 'cannot answer 3->0'
run 1 sweep --dim 3 --points random:20:1 --models 'N|R|R2N +R2R' && says 'borrows nothing'
for word in all paper105 table4; do run 1 sweep --dim 3 --models $word && says "models $word is for --dim 2"; done
for word in named paths; do run 1 sweep --models $word && says "models $word is for --dim 3"; done
run 1 sweep --dim 3 --models F9 && says "'F9' is no model of volumes.*F1 to F6"
run 1 delaunay random:10:1 --dim 3 --model 'N|E|R|E2R|R2N|N2E|E2E|R2E|R2R|N2N' && says 'none of the models'
run 0 delaunay random:1225:1 --model 'F|N|N2F' --json && prints '"checksum":"714e3f4d1a8d5edb"'
run 0 delaunay random:50:1 -o square.off && run 0 check square.off --json && prints '"inconsistent_edges":0'
run 0 delaunay random:50:1 --model 'N|F|N2F' -o unordered.vtk && run 0 check unordered.vtk --json &&
  prints '"inconsistent_edges":0' && prints '"nonmanifold_edges":0'
run 0 delaunay random:50:1 -o picture.svg
grep -q '<polygon' picture.svg || fail 'a picture has polygons'
printf '0 0\n1 0\n2,0\n# a comment\n' >line.txt
run 0 delaunay line.txt --json && prints '"dimension":1' && prints '"cells":0' && prints '"checksum":"0000000000000000"'
printf '' >nothing.txt
run 0 delaunay nothing.txt --json && prints '"dimension":-1'
run 1 delaunay no_such_file.txt && says 'no_such_file.txt'
printf '0 0\n1 nan\n' >nan.txt
run 1 delaunay nan.txt -o bad.off && says 'nan.txt:2' && absent bad.off
run 1 delaunay random:10:1 --model 'N|F' && says '2->0' && says 'add F2N'
run 1 delaunay random:10:1 --model 'N|F|F2M' && says "'F2M'"
run 1 delaunay random:10:1 --model 'N|F|F2F' && says '2->0'
run 1 delaunay random:10:1 --model cmap2 && says "'cmap2'"
run 1 delaunay random:abc && says 'random'
run 1 delaunay random:10:1 -o no_such_folder/x.off && says 'no_such_folder'
run 1 delaunay random:10:1 -o x.unknown && says 'unknown' && absent x.unknown
run 1 delaunay random:99999999999:1 && says 'more cells'
(ulimit -v 300000 && "$gmds" delaunay random:9000000:1 -o big.off >out 2>err)
[ $? = 1 ] && says 'memory' && absent big.off
empty_of_leftovers

# ---- sweep
run 0 sweep --points random:300:2 --csv sweep.csv --plot sweep.svg
[ "$(wc -l <sweep.csv)" = 115 ] || fail "the sweep has $(wc -l <sweep.csv) lines"
[ "$(head -1 sweep.csv)" = "model,points,cells,seconds,bytes,peak_bytes,checksum,status" ] || fail "sweep header"
[ "$(grep -c ',ok$' sweep.csv)" = 114 ] || fail "rows that are ok"
grep -q '</svg>' sweep.svg || fail 'the plot is cut short'
run 0 sweep --points grid:35 --models all --expect ddcec7cabf7fc153 --jobs 2
run 0 sweep --points random:1225:1 --models all --expect 714e3f4d1a8d5edb --csv all.csv
[ "$(grep -c ',ok$' all.csv)" = 114 ] || fail "rows equal to CGAL's checksum"
run 0 sweep --points random:1225:1 --models table4 --expect 714e3f4d1a8d5edb --csv table4.csv
paper="2334720 2342912 3526656 3547136 4038656 5672960 5726208 5332992 5902336 2314240 5136384 2289664 942080 987136 4567040 1454080 1499136"
row=2
for bytes in $paper; do
  ours=$(sed -n "${row}p" table4.csv | cut -d, -f5)
  [ $((10 * ours)) -le "$bytes" ] || fail "row $((row - 1)) of Table 4: $ours bytes, the paper's $bytes"
  row=$((row + 1))
done
run 0 sweep --points random:100:1 --models paper105 --csv p.csv
[ "$(wc -l <p.csv)" = 106 ] || fail "paper105 has $(wc -l <p.csv) lines"
run 0 sweep --points random:100:1 --models 'N|F|F2N,N|F|N2F' && prints '2 of 2'
run 1 sweep --points random:100:1 --models all --expect 0123456789abcdef && says 'differ'
run 0 sweep --points random:1225:1 --models 'cmap,N|F|F2N|F2F' --expect 714e3f4d1a8d5edb && prints '2 of 2'
run 0 sweep --dim 3 --points random:50:1 --models 'cmap,R1' && prints '2 of 2'
run 1 sweep --points random:100:1 --models 'cmap +F2F' && says 'borrows none'
run 0 delaunay grid:12 --model cmap -o map.off --json && prints '"model":"cmap"'
run 0 delaunay grid:4 --dim 3 --model cmap -o map.vtk --json && prints '"dimension":3'
run 1 sweep --points random:100:1 --models 'N|F|F2N,N|Q' && says "'Q'"
run 1 sweep --points random:100:1 --models 'N|F|F2N' --csv no_such_folder/x.csv && says 'no_such_folder'
run 1 sweep --points missing.xy

# ---- bench
run 0 bench cells --n 20 --model 'N|E|F|N2E|N2F|E2N|E2F|F2N|F2E|F2F' --json && prints '"face_by_face":true'
for key in model n nodes edges triangles seconds construct area stars edges marks attributes bytes peak_bytes; do
  prints "\"$key\":"
done
prints '"nodes":441,' && prints '"edges":1240,' && prints '"triangles":800,'
run 0 bench cells --n 20 && prints 'areas of all faces'
run 0 bench cells --n 1 --model 'N|F|N2F' --json && prints '"triangles":2'
# the seven relations of half a million triangles
run 0 bench cells --n 500 --model 'N|E|F|N2E|N2F|E2N|E2F|F2N|F2E|F2F' --json
bytes=$(sed 's/.*"bytes":\([0-9]*\).*/\1/' out)
[ "$bytes" -le 56000000 ] || fail "seven relations of 500,000 triangles take $bytes bytes"
# every model: the answers are checked by the command, a model that has no stars says null
stars=0
for model in $("$gmds" models --dim 2 --csv | awk -F, '$2==1{print $1}'); do
  run 0 bench cells --n 6 --model "$model" --json
  prints '"construct":[0-9]' && prints '"area":[0-9]' && prints '"edges":[0-9]'
  stars=$((stars + $(grep -c '"stars":[0-9]' out)))
done
[ "$stars" = "$("$gmds" models --dim 2 --csv | awk -F, '$2==1 && $9!="none"' | wc -l)" ] || fail "$stars models have stars"
run 0 bench predicates --json && prints '"incircle_perturbed":{"uniform":[0-9.]*,"lattice":[0-9.]*}'
run 0 bench predicates && prints 'nanoseconds a call'
run 0 bench hexgrid --n 5 --json && prints '"hexes":125,"darts":3000,"seconds":[0-9.]*,"bytes_per_hex":[0-9.]*'
run 0 bench hexgrid --n 2 && prints '12 faces sewn'
run 2 bench hexgrid && says 'needs --n'
run 2 bench hexgrid --n 3 --model cmap && says 'belongs to'
run 0 bench cells --n 20 --model cmap --json && prints '"face_by_face":false'
run 1 bench cells --n 5 --model 'N|F' && says '2->0'
run 2 bench
run 2 bench cells && says 'needs --n'
run 2 bench cells --n 0
run 2 bench cells --n ten
run 2 bench nothing
run 2 bench predicates --n 5
run 2 bench predicates --model 'N|F|F2N'
run 1 bench cells --n 5 --model 'N|F|F2N +N2F' && says 'borrows'

# ---- homology
run 2 homology && says 'missing'
run 2 homology torus:9 --threads 0 && says 'from 1 to 256'
run 2 homology torus:9 --clusters boxes && says "not 'boxes'"
run 2 homology torus:9 --clusters grid:41
run 2 homology torus:9 --clusters ranges:
run 1 homology torus:2 && says 'torus:2: expected torus:N with a whole number from 3'
run 1 homology nothing.off
run 1 homology torus:9 --generators g.xyzzy && absent g.xyzzy
run 0 homology sphere:9 && prints 'closed, orientable' && prints 'Betti numbers 1, 0, 1'
for how in one ranges ranges:7 grid grid:3; do
  for threads in 1 2 5; do
    run 0 homology torus:30 --clusters $how --threads $threads --json &&
      prints '^{"vertices":900,"edges":2700,"faces":1800,"components":1,"closed":true,"orientable":true,"betti":\[1,2,1\],"seconds":{"build":' &&
      prints '"removed":{"inner":'
    sed 's/"seconds":{[^}]*}//' out >torus.$threads
    cmp -s torus.1 torus.$threads || fail "the counts of --clusters $how depend on the threads"
  done
done
run 0 homology torus:30 --generators g.vtk && run 0 info g.vtk && prints 'triangle *1800' && prints 'of cells *generator: int'
printf 'OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 1 1\n3 0 1 2\n3 0 1 3\n3 1 0 4\n' >book.off
run 1 homology book.off && says 'on the edge of vertices 0 and 1'
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >one.off
run 0 homology one.off --json && prints '"closed":false' && prints '"betti":\[1,0,0\]'

# ---- borrowed relations: the result and the bytes of the model itself, the peak of the one that it borrows from
borrowed='N|F|F2N,N|F|F2N +N2F,N|F|N2F +F2N +F2F,N|E|F|N2E|E2F +F2E,N|F|F2N|F2F+N2F,N|E|F|E2N|F2E +N2E +N2F +E2F +F2N +F2F'
run 0 sweep --points random:1225:1 --models "$borrowed" --expect 714e3f4d1a8d5edb --csv b.csv
[ "$(cut -d, -f1 b.csv | tail -n +2 | tr '\n' ,)" = 'N|F|F2N,N|F|F2N +N2F,N|F|N2F +F2N +F2F,N|E|F|N2E|E2F +F2E,N|F|F2N|F2F +N2F,N|E|F|E2N|F2E +N2E +N2F +E2F +F2N +F2F,' ] ||
  fail "rows of borrowed relations: $(cut -d, -f1 b.csv)"
tail -n +2 b.csv | while IFS=, read -r model _ _ _ bytes peak _; do
  own=${model%% +*}
  [ "$bytes" = "$(awk -F, -v m="$own" '$1 == m {print $5}' all.csv)" ] || echo "bytes of $model: $bytes"
  [ "$peak" -ge "$bytes" ] || echo "peak of $model: $peak"
done >differences
[ ! -s differences ] || fail "$(cat differences)"
[ "$(awk -F, '$1 == "N|F|F2N +N2F" {print $6}' b.csv)" -gt "$(awk -F, '$1 == "N|F|F2N" {print $6}' b.csv)" ] ||
  fail 'a borrowed relation does not count in peak_bytes'
run 0 delaunay grid:35 --model 'N|F|N2F +F2N' --json -o lent.off && prints '"checksum":"ddcec7cabf7fc153"' &&
  prints '"model":"N|F|N2F +F2N"'
run 0 check lent.off --json && prints '"nonmanifold_edges":0'
run 1 sweep --points random:100:1 --models 'N|F|F2N,N|F|F2N +F2N' && says 'stores F2N'
run 1 delaunay random:10:1 --model 'N|F|F2N +F2E' && says 'keeps no edges'
run 1 delaunay random:10:1 --model 'N|F|F2N +F2X' && says "'F2X'"
run 1 delaunay random:10:1 --model 'N|F|F2N +N2N' && says 'cannot borrow N2N'
run 1 delaunay random:10:1 --model 'N|F|F2N +N2F +N2F' && says 'twice'
run 1 delaunay random:10:1 --model 'N|F|F2N +N2F|F2F' && says 'not one relation'
run 1 delaunay random:10:1 --model 'N|F|F2N +F' && says 'not one relation'
run 1 delaunay random:10:1 --model 'N|F|F2N +F2F N2F'
run 1 sweep --points random:100:1 --models "N|F|F2N$(printf '%300s' '')XYZ" && says 'longer than any'
run 0 delaunay random:10:1 --model 'F|N|F2N+F2F' --json && prints '"model":"N|F|F2N +F2F"'
run 1 delaunay random:10:1 --model 'N|F|F2N +'
run 1 delaunay random:10:1 --model 'N|F +F2N' && says '2->0'

# ---- convert, info, check
cat >cube.off <<'END'
OFF
8 6 12
0 0 0
1 0 0
1 1 0
0 1 0
0 0 1
1 0 1
1 1 1
0 1 1
4 3 2 1 0
4 4 5 6 7
4 0 1 5 4
4 1 2 6 5
4 2 3 7 6
4 3 0 4 7
END
run 0 convert cube.off cube.vtk && run 0 convert cube.vtk cube.mesh && run 0 convert cube.mesh back.off
run 0 convert back.off again.mesh
cmp -s cube.mesh again.mesh || fail 'a round trip changes the mesh'
run 0 info cube.vtk --json && prints '"quadrilateral":6' && prints '"points":8'
run 0 check cube.off --json && prints '"euler":2' && prints '"border_edges":0' && prints '"inconsistent_edges":0'
head -n 9 cube.off >cut.off
run 1 info cut.off && says 'cut.off'
run 1 convert cut.off cut.vtk && absent cut.vtk
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n' >index.off
run 1 check index.off && says 'index.off:6'
run 1 convert cube.off cube.xyzw && absent cube.xyzw
prints_all() { for claim in "$@"; do prints "$claim"; done; }

# ---- check of volumes: a cube; three tetrahedra on a face, one inside out; two that share a node; what is no mesh
printf 'MeshVersionFormatted 2\nDimension 3\nVertices 9\n0 0 0 0\n1 0 0 0\n1 1 0 0\n0 1 0 0\n0 0 1 0\n1 0 1 0\n1 1 1 0\n0 1 1 0\n5 5 5 0\nHexahedra 1\n1 2 3 4 5 6 7 8 0\nEnd\n' >solid.mesh
run 0 check solid.mesh --json && prints_all '"nodes":9,"edges":12,"faces":6,"regions":1,"euler":1,"components":1,"isolated_nodes":1' \
  '"inverted":0,"flat":0' '"border":{"nodes":8,"edges":12,"euler":2,"manifold":true,"closed":true},"volume":1,' '"min":1,'
run 0 check solid.mesh && prints_all 'border of 6 faces, Euler characteristic 2, a closed manifold' 'every relation of the sixteen agrees'
run 0 info solid.mesh --json && prints '"hexahedron":1'
printf 'MeshVersionFormatted 2\nDimension 3\nVertices 6\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 -1 0\n1 1 -1 0\nTetrahedra 3\n1 2 3 4 0\n1 3 2 5 0\n1 2 3 6 0\nEnd\n' >three.mesh
run 0 check three.mesh --json && prints_all '"nonmanifold_faces":1' '"inverted":1'
run 0 check three.mesh && prints_all '1 faces with more than two regions' '1 inverted regions, first region 2' 'the sixteen but R2R'
printf 'MeshVersionFormatted 2\nDimension 3\nVertices 7\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n-1 0 0 0\n0 -1 0 0\n0 0 -1 0\nTetrahedra 2\n1 2 3 4 0\n1 5 7 6 0\nEnd\n' >touching.mesh
run 0 check touching.mesh --json && prints_all '"components":2' '"nonmanifold_nodes":1' '"nonmanifold_edges":0' '"manifold":false'
# a tetrahedron with a point twice, which leaves volumes without a region; a flat one; one listed twice; a crossed face
printf 'MeshVersionFormatted 2\nDimension 3\nVertices 3\n0 0 0 0\n1 0 0 0\n0 1 0 0\n' >none.mesh
printf 'Tetrahedra 1\n1 2 3 3 0\nEnd\n' >>none.mesh
run 0 check none.mesh --json && prints_all '"regions":0' '"degenerate":1' '"closed":false'
run 0 check none.mesh && prints_all '0 regions in 0 components' '1 degenerate cells left out' '^  no border$'
printf 'MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n1 1 0 0\n' >flat.mesh
printf 'Tetrahedra 1\n1 2 3 4 0\nEnd\n' >>flat.mesh
run 0 check flat.mesh --json && prints_all '"regions":1' '"inverted":0,"flat":1'
sed -e 's/^Tetrahedra 1/Tetrahedra 2/' -e 's/^1 2 3 4 0/&\n2 1 3 4 0/' flat.mesh >again.mesh
run 0 check again.mesh --json && prints_all '"regions":2' '"repeated":1' '"border_faces":0' '"closed":false'
run 0 check again.mesh && prints_all '1 regions with the nodes of another, first region 1' '^  no border$'
sed -e 's/^Vertices 9/Vertices 13/' -e 's/^5 5 5 0/&\n0 0 2 0\n1 0 2 0\n1 1 2 0\n0 1 2 0/' \
  -e 's/^Hexahedra 1/Hexahedra 2/' -e 's/^1 2 3 4 5 6 7 8 0/&\n5 7 6 8 10 11 12 13 0/' solid.mesh >crossed.mesh
run 0 check crossed.mesh --json && prints_all '"regions":2' '"crossed_faces":1'
run 0 check crossed.mesh &&
  prints_all '1 faces whose regions list their nodes in other orders' 'the eight without faces and R2R'
cat >polyhedron.vtk <<'END'
# vtk DataFile Version 3.0
a cube by its faces
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 8 double
0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1
CELLS 1 32
31 6 4 0 1 2 3 4 4 5 6 7 4 0 1 5 4 4 1 2 6 5 4 2 3 7 6 4 3 0 4 7
CELL_TYPES 1
42
END
run 0 check polyhedron.vtk --json && prints_all '"regions":1' '"volume":1,' '"min":0.523598' '"closed":true'
sed 's/^1 2 3 6/1 2 3 9/' three.mesh >bad.mesh
run 1 check bad.mesh && says 'bad.mesh:13'
run 2 convert cube.off
run 0 convert random:100:1 points.f64
run 0 convert points.f64 points.txt
run 0 info points.f64 --json && prints '"points":100' && prints '"dim":2'
run 0 delaunay points.txt --json && prints '"points":100'
# ---- volumes and attributes
cat >two.msh <<'END'
$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
1
3 7 "body"
$EndPhysicalNames
$Nodes
5
1 0 0 0
2 1 0 0
3 0 1 0
4 0 0 1
5 1 1 1
$EndNodes
$Elements
3
1 2 2 9 1 1 2 3
2 4 2 7 1 1 2 3 4
3 4 2 7 1 5 4 3 2
$EndElements
$NodeData
1
"heat"
0
3
0
1
5
1 0.1
2 0.2
3 0.3
4 0.4
5 0.5
$EndNodeData
END
run 0 info two.msh --json && prints '"tetrahedron":2' && prints '"triangle":1' && prints '"unread":1' &&
  prints '{"of":"points","name":"heat","type":"double","components":1}' &&
  prints '{"of":"cells","name":"physical","type":"int","components":1}'
run 0 info two.msh && prints 'of points *heat: double' && prints 'not read *1 '
run 0 convert two.msh two.vtu && says '1 arrays or sections'
run 0 convert two.msh two.vtk --binary --format-version 5.1
run 0 convert two.vtk two2.vtk --text && [ ! -s err ] || fail "a note about nothing: $(cat err)"
run 0 info two2.vtk --json && prints '"name":"heat"' && prints '"name":"geometrical"' && prints '"unread":0'
run 0 convert two2.vtk back.msh --format-version 2.2 && run 0 convert back.msh back.vtk && cmp -s two2.vtk back.vtk ||
  fail 'attributes change on their way through .msh'
run 0 convert two2.vtk back4.msh --binary && run 0 convert back4.msh back4.vtk && cmp -s two2.vtk back4.vtk ||
  fail 'attributes change on their way through binary .msh'
run 0 convert two.msh two.mesh && says 'attributes left out: heat of points, physical of cells, geometrical of cells'
run 1 convert two.msh two.off && says 'OFF cannot hold cell 1' && absent two.off
run 1 convert two.msh two.mesh --binary && says 'Medit is not written in binary'
run 1 convert two.msh three.msh --format-version 4.0 && says 'not written in version 4.0' && absent three.msh
run 2 convert two.msh three.msh --format-version four
run 2 convert two.msh three.msh --text --binary
if "$gmds" info two.vtu >out 2>err; then
  prints 'tetrahedron *2' && run 0 convert two.vtu two3.vtk && cmp -s two2.vtk two3.vtk || fail '.vtu changes attributes'
else
  says 'built without Expat'
fi
"$gmds" --help >/dev/full 2>err && fail 'a help that cannot be printed succeeds'
run 1 info "$dir"
cp cube.off same.off
run 1 convert nan.txt same.off
cmp -s cube.off same.off || fail 'a failed run changed the file that was there'
empty_of_leftovers

echo "$claims runs, $failures claims failed"
[ "$failures" = 0 ]
