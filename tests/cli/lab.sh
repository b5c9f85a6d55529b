#!/usr/bin/env bash
# The command line of sightline-lab, as a student and as a teacher use it. usage: lab.sh FOLDER_OF_PROGRAMS
# shellcheck source=tests/cli/lib.sh disable=SC2016
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"
programs=$(realpath -- "${1:?usage: lab.sh FOLDER_OF_PROGRAMS}")
lab=$programs/sightline-lab
mine=$scratch/mine
sphere=$mine/00-first-picture/sphere.h
solution=$root/labs/00-first-picture/solution/sphere.h

run "$lab" --help
expect_exit 0
expect_quiet
for word in list start check watch hint view replay bench mine submit grade handout prove --mine 'Exit status'; do
  expect_prints "$word"
done

# ---- What is refused

refuses 2 --no-such-option "$lab" --no-such-option
refuses 2 "unknown lab '99'; expected one of 00-first-picture" "$lab" --mine "$mine" start 99
refuses 2 'LAB is required' "$lab" --mine "$mine" check
refuses 1 'expected the lab'\''s files: ./sightline lab start 00' "$lab" --mine "$mine" check 00
refuses 1 'no such folder' "$lab" --mine "$mine" replay 00 --case hit:0,0,0,0,0,0,0,0,0,0

# ---- A student

run "$lab" --mine "$mine"
expect_exit 0
expect_prints 'not started'
run "$lab" --mine "$mine" start 0
expect_exit 0
expect_prints 'labs/00-first-picture/README.md'
check 'a starter with holes' grep -q 'not_yet_implemented("hit_sphere", "2. Where a ray meets a sphere")' "$sphere"
check 'no solution' bash -c '! grep -q discriminant "$0"' "$sphere"
refuses 1 'what you have written' "$lab" --mine "$mine" start 00
run "$lab" --mine "$mine" check first-picture
expect_exit 1
expect_quiet
expect_prints 'not yet implemented: hit_sphere, see 2. Where a ray meets a sphere'
expect_prints 'failing 7 of 7'
run "$lab" --mine "$mine" hint 00
expect_exit 0
expect_prints 'not yet implemented: camera_ray'

echo 'int broken(' >>"$sphere"
run "$lab" --mine "$mine" check 00
expect_exit 1
expect_prints 'does not build'
expect_prints error

# The simplest question that is answered wrongly, its replay, and hints that grow.
sed 's/const double a = glm::dot(ray.direction, ray.direction);/const double a = 1;/' "$solution" >"$sphere"
run "$lab" --mine "$mine" check 00 --no-pictures --json report.json
expect_exit 1
expect_prints 'replay 00 --case '\''hit:'
expect_file report.json
case=$(sed -n "s/.*--case '\(hit:[^']*\)'.*/\1/p" "$scratch/stdout")
check 'a small case' test "${#case}" -lt 40
run "$lab" --mine "$mine" replay 00 --no-pictures --case "$case"
expect_exit 1
expect_prints 'expected  t = '
for count in 1 2; do
  run "$lab" --mine "$mine" hint 00
  expect_exit 0
  expect_prints "$count of 2:"
done
refuses 2 "--case: expected CHECK:NUMBERS" "$lab" --mine "$mine" replay 00 --case hot:1
refuses 2 '--case: expected 10 whole numbers from -9 to 9' "$lab" --mine "$mine" replay 00 --case hit:1,2
refuses 2 '--case: expected 10 whole numbers from -9 to 9' "$lab" --mine "$mine" replay 00 --case hit:1,2,3,4,5,6,7,8,9,10
refuses 2 "unknown check 'hot'" "$lab" --mine "$mine" check 00 --only hot

# What fails is drawn, and what works as well.
if [[ -x $programs/sightline-view ]]; then
  run "$lab" --mine "$mine" replay 00 --case "$case"
  expect_exit 1
  expect_prints pictures/hit.png
  check 'a picture of the case' test -s "$mine/00-first-picture/pictures/hit.png"
  run "$lab" --mine "$mine" view 00
  expect_exit 0
  check 'the picture' test -s "$mine/00-first-picture/pictures/first-picture.png"
  # Numbers that are not finite, and what is no drawing.
  nan='{"title": "t", "caption": "c", "panels": [{"title": "", "chart": {"x_label": "x", "y_label": "y", "is_log_x": false,
    "is_log_y": true, "curves": [{"name": "n", "role": "right", "is_dots": false, "points": [[0, 0], [1, -1], [2, 3]]}]}}]}'
  run bash -c 'printf %s "$1" >d.json; "$0" drawing d.json --out d.png' "$programs/sightline-view" "$nan"
  expect_exit 0
  expect_file d.png
  for text in '' '{' '[]' '{"title": 1}' '{"title": "", "caption": "", "panels": [{"title": ""}]}'; do
    run bash -c 'printf %s "$1" >d.json; "$0" drawing d.json --out d.png' "$programs/sightline-view" "$text"
    expect_exit 1
    expect_one_line
    expect_says 'd.json: expected a drawing in JSON'
  done
  refuses 1 'no.json: expected a drawing in JSON' "$programs/sightline-view" drawing no.json --out d.png
  refuses 2 "ends in .png" "$programs/sightline-view" drawing no.json --out d.jpeg
fi

# A program that crashes, hangs or prints is told of.
sed 's/  const double a = glm::dot(ray.direction, ray.direction);/  std::abort();&/' "$solution" >"$sphere"
run "$lab" --mine "$mine" check 00 --only hit --no-pictures
expect_exit 1
expect_prints 'a crash (signal 6'
sed 's/  const double a = glm::dot(ray.direction, ray.direction);/  for (volatile int i = 0;; i = i + 1) {}&/' "$solution" >"$sphere"
run "$lab" --mine "$mine" check 00 --only hit --no-pictures
expect_exit 1
expect_prints 'a loop that does not end?'

cp "$solution" "$sphere"
run "$lab" --mine "$mine" check 00
expect_exit 0
expect_prints passes
run "$lab" --mine "$mine" replay 00 --case "$case" --no-pictures
expect_exit 0
run "$lab" --mine "$mine" list
expect_prints 'First picture                passes'
echo >>"$sphere"
run "$lab" --mine "$mine" list
expect_prints 'passes, changed since'
run "$lab" --mine "$mine" start 00 --again
expect_exit 0
check 'what was written kept' cmp -s "$sphere.before" <(cat "$solution" <(echo))
cp "$solution" "$sphere"
run "$lab" --mine "$mine" submit 00
expect_exit 0
check 'an archive' test -s "$mine/submissions/00-first-picture.tar.gz"

# Saving a file checks again; keys.
run bash -c '(sleep 2; cp "$1" "$2"; sleep 4; printf hlq) | "$0" --mine "$3" watch 00' "$lab" "$solution" "$sphere" "$mine"
expect_exit 0
expect_prints 'Every check passes'
check 'two checks' test "$(grep -c 'Lab 00, First picture' "$scratch/stdout")" -ge 2

# ---- A teacher

if "$lab" --mine "$mine" grade "$mine" --out "$scratch/none" >/dev/null 2>&1; then
  class=$scratch/class
  for student in good '=weird,name' allocating deleting forking reading; do
    mkdir -p "$class/$student/00-first-picture"
    cp "$solution" "$class/$student/00-first-picture/"
  done
  cp "$mine/submissions/00-first-picture.tar.gz" "$class/packed.tar.gz"
  touch "$scratch/treasure"
  plant() { # STUDENT CODE: in the function that shades
    sed -i "s|  // lab:hole shade .*|  $2|; s|#include \"sightline/math/ray.h\"|&\n#include <filesystem>\n#include <unistd.h>|" \
      "$class/$1/00-first-picture/sphere.h"
  }
  plant allocating 'std::vector<char> all(100ull << 30, 1); if (all[7] == 2) return 2;'
  plant deleting "std::error_code e; std::filesystem::remove_all(\"$scratch/treasure\", e); std::filesystem::remove_all(\"$class/good\", e); if (std::filesystem::exists(\"$scratch\")) return 9;"
  plant forking 'for (int i = 0; i < 5; ++i) if (fork() >= 0) return 9;'
  sed -i 's|#include "sightline/math/ray.h"|&\n#include "/etc/passwd"|' "$class/reading/00-first-picture/sphere.h"
  run "$lab" grade "$class"/* --lab 00 --seed 5 --out grades
  expect_exit 0
  expect_prints 'good: 00: 7 of 7'
  expect_prints 'packed: 00: 7 of 7'
  expect_prints '=weird,name: 00: 7 of 7'
  expect_prints 'allocating: 00: 5 of 7'
  expect_prints 'deleting: 00: 7 of 7' # it sees nothing of what it would delete
  expect_prints 'forking: 00: 7 of 7' # no process is started
  expect_prints 'reading: 00: does not build'
  check 'the treasure' test -e "$scratch/treasure"
  check 'the other submission' test -e "$class/good/00-first-picture/sphere.h"
  for file in good/results.json good/report.txt junit.xml class.csv class.html; do expect_file "grades/$file"; done
  check 'a score of 7' grep -q '"score": 7.0' "$work/grades/good/results.json"
  check 'no formula' grep -q "\"'=weird,name\",7,7" "$work/grades/class.csv"
  refuses 2 "two submissions of 'good'" "$lab" grade "$class/good" "$class/good"
else
  echo 'grading is not tested: this machine offers no sandbox'
fi
run "$lab" grade "$mine" --trusted --lab 00 --out grades
expect_exit 0
expect_prints '7 of 7'

run "$lab" handout students
expect_exit 0
check 'a starter' grep -q not_yet_implemented "$work/students/labs/00-first-picture/starter/sphere.h"
check 'no solution' test -z "$(find "$work/students" -path '*/solution/*' -o -name mutants.txt)"

finish
