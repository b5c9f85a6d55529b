#!/usr/bin/env bash
# Breaks each rule of house.sh once, in a copy of the tree, and expects each to be named.
set -euo pipefail
root=$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")
copy=$(mktemp -d)
trap 'rm -rf -- "$copy"' EXIT
for entry in "$root"/* "$root"/.c*; do
  case ${entry##*/} in build | out | data) ;; *) cp -r -- "$entry" "$copy" ;; esac
done
mkdir -p "$copy/data"
cd -- "$copy"

expected=()
# breaks EXPECTED FILE [LINE...]: the file is made of, or gets, these lines.
breaks() {
  local file=$2
  expected+=("$1")
  mkdir -p "$(dirname -- "$file")"
  shift 2
  printf '%s\n' "$@" >>"$file"
}
include() { printf '#include %s' "$1"; }
structure='static_assert(Accelerator<Planted>);'
pragma='#pragma once'
lib=lib/sightline

breaks 'planted_a.h: math may not include shape/mesh.h' $lib/math/planted_a.h "$pragma" "$(include '"sightline/shape/mesh.h"')"
breaks 'planted_b.h: accel may not include shape/mesh.h' $lib/accel/planted_b.h "$pragma" "$(include '"sightline/shape/mesh.h"')"
breaks 'planted_c.h is a structure that registry.h does not include' $lib/accel/planted_c.h "$pragma" "$structure" \
  "$(include '"sightline/accel/brute_force.h"')"
breaks 'planted_c may not include the structure brute_force' $lib/accel/planted_c.h
breaks 'planted_d may not include the structure planted_c_build' $lib/accel/planted_d.h "$pragma" \
  "$(include '"sightline/accel/planted_c_build.h"')"
for header in vtkActor.h benchmark/benchmark.h embree3/rtcore.h CGAL/AABB_tree.h gtest/gtest.h; do
  breaks "planted_e.cpp: lib may not include <$header>" $lib/io/planted_e.cpp "$(include "<$header>")"
done
breaks 'planted_f.cpp: math may not include <tbb/task_group.h>' $lib/math/planted_f.cpp "$(include '<tbb/task_group.h>')"
breaks 'lib names headers as' $lib/query/planted_g.cpp "$(include '"../math/vec.h"')"
breaks 'room: planted_room has no line' $lib/planted_room/README.md room
breaks 'sightline::Ray is defined in' lib/sightline/shape/planted.h "$(printf '#pragma once\nnamespace sightline {\nstruct Ray {\n};\n}  // namespace sightline')"
breaks 'lab.cpp: no lab includes another' labs/01-planted/lab.cpp "$(include '"labs/02-planted/answer.h"')"
breaks 'long.cpp has 401 lines' tests/planted/long.cpp "$(yes '//' | head -n 401)"
breaks 'large.txt has 1048577 bytes' tests/planted/large.txt
head -c 1048577 /dev/zero >tests/planted/large.txt
breaks 'planted.txt does not belong at the top level' planted.txt text
breaks 'viz/README.md is missing' viz/planted.cpp
rm -f viz/README.md
breaks 'bare.h needs one #pragma once' tests/planted/bare.h 'int planted();'
breaks 'unfinished: tests/planted/later.cpp:1' tests/planted/later.cpp "// TO""DO"
breaks 'machine path: tests/planted/path.cpp:1' tests/planted/path.cpp "open(\"/ho""me/me/x.ply\");"
breaks 'registry host: tests/planted/host.sh:1' tests/planted/host.sh "get https://registry.npm""js.org/x"
breaks 'magic epsilon: lib/sightline/math/planted_h.h:2' $lib/math/planted_h.h "$pragma" 'if (t < 1e-6f) return;' \
  'if (t < kEpsilon) return;' 'if (t < 0.00001) return;' 'const float eps_ = 1;' '// 1e-6' \
  'const float unit = std::numeric_limits<float>::epsilon(), small = 0x1p-24f, half = 0.5f, tenth = 1e-1f;'
for line in 3 4 5; do breaks "magic epsilon: lib/sightline/math/planted_h.h:$line" $lib/math/planted_h.h; done

status=0
found=$(tests/house.sh . 2>&1) || status=$?
failures=0
complain() { echo "$*"; failures=$((failures + 1)); }
[[ $status == 1 ]] || complain "house.sh ended with $status, expected 1"
for line in "${expected[@]}"; do [[ $found == *"$line"* ]] || complain "house.sh does not find: $line"; done
[[ $found != *planted_h.h:[67]* ]] || complain 'house.sh refuses a comment or an honest number'
((failures == 0)) || { printf 'house.sh printed:\n%s\n' "$found"; exit 1; }
echo "house.sh finds all ${#expected[@]} planted violations"
