#!/usr/bin/env bash
# The rules of the house that a compiler does not see: who may include whom, sizes, names, and what no file may contain.
# usage: house.sh ROOT. Prints each violation and ends with 1 when there is one.
set -euo pipefail
cd -- "${1:?usage: house.sh ROOT}"

top_level=' .ci .clang-format .clang-tidy .gitignore CMakeLists.txt CMakePresets.json LICENSE README.md bench data labs lib sightline tests viz '
folders_with_readme='lib bench viz tests data'
longest_file=400        # lines
largest_file=1048576    # bytes

# A room may include itself and what stands after its name; SYSTEM headers that have a folder, what stands after the bar.
arrows='
math    | glm hwy
shape   math | glm
accel   math | glm sys tbb
query   accel shape math | glm tbb
csg     accel shape math | glm
noise   math | glm
texture noise io math | glm OpenImageIO
scene   shape csg texture io math | glm tbb
render  scene query accel csg texture shape io math | glm tbb
io      math shape | glm assimp OpenImageIO nlohmann sys
'
# A structure is a header of accel/ that ends with static_assert(Accelerator<...>). Only registry.h includes structures; a
# structure's parts, whose names begin with its own and _, belong to it alone; all other headers of accel/ are shared.

violations=0
violation() {
  printf '%s\n' "$*"
  violations=$((violations + 1))
}

# matches PATTERN WHAT FILE...: a violation for each line of the files that matches.
matches() {
  local pattern=$1 what=$2 line
  shift 2
  (($#)) || return 0
  while IFS= read -r line; do violation "$what: $line"; done < <(grep -H -n -I -E -e "$pattern" -- "$@" | cut -c 1-160)
}

list_files() {
  if [[ -e .git ]] && git ls-files >/dev/null 2>&1; then
    git ls-files --cached --others --exclude-standard
  else
    find . -path ./.git -prune -o -path ./build -prune -o -path ./out -prune -o -path ./data/cache -prune -o -type f -print |
      cut -c 3-
  fi
}

files=() sources=() headers=() library=()
while IFS= read -r file; do
  [[ -f $file ]] || continue
  files+=("$file")
  case $file in *.h | *.cpp) sources+=("$file") ;; esac
  case $file in *.h) headers+=("$file") ;; esac
  case $file in lib/*.h | lib/*.cpp) library+=("$file") ;; esac
done < <(list_files | sort)
((${#files[@]})) || violation 'no files at all'

# ---- Who includes whom

check_room_include() { # FILE ROOM HEADER: a header of this project
  local file=$1 room=$2 to=$3 allowed
  allowed=$(sed -n "s/^$room \([^|]*\)|.*/\1/p" <<<"$arrows")
  [[ " $room $allowed " == *" ${to%%/*} "* ]] || violation "include: $file: $room may not include $to"
  [[ $room == accel && $to == accel/* ]] || return 0
  local from=${file##*/} name=${to#accel/} structure
  from=${from%.*} name=${name%.h}
  [[ $from != registry ]] || return 0
  for structure in "${structures[@]}"; do
    [[ $name == "$structure" || $name == "${structure}_"* ]] || continue
    [[ $from == "$structure" || $from == "${structure}_"* ]] ||
      violation "include: $file: $from may not include the structure $name"
  done
}

check_system_include() { # FILE ROOM HEADER
  local file=$1 room=$2 to=$3 allowed
  case $to in
    vtk* | benchmark/* | embree* | CGAL/* | gtest/* | gmock/* | rapidcheck* | CLI/* | libnoise/* | noise/*)
      violation "include: $file: lib may not include <$to>"
      return ;;
  esac
  [[ $to == */* ]] || return 0
  allowed=$(sed -n "s/^$room [^|]*| *//p" <<<"$arrows")
  [[ " $allowed " == *" ${to%%/*} "* ]] || violation "include: $file: $room may not include <$to>"
}

structures=()
for file in lib/sightline/accel/*.h; do
  grep -q '^static_assert(Accelerator<' "$file" || continue
  name=${file##*/}
  structures+=("${name%.h}")
  grep -q -x -F "#include \"sightline/accel/$name\"" lib/sightline/accel/registry.h ||
    violation "registry: $file is a structure that registry.h does not include"
done
((${#structures[@]})) || violation 'registry: accel/ has no structure'

while IFS= read -r line; do
  file=${line%%:*} to=${line#*:}
  room=${file#lib/sightline/}
  room=${room%%/*}
  if [[ $to =~ \#\ *include\ *\"sightline/([^\"]*)\" ]]; then
    check_room_include "$file" "$room" "${BASH_REMATCH[1]}"
  elif [[ $to =~ \#\ *include\ *\<([^\>]*)\> ]]; then
    check_system_include "$file" "$room" "${BASH_REMATCH[1]}"
  else
    violation "include: $file: lib names headers as \"sightline/ROOM/FILE\" or <FILE>, not $to"
  fi
done < <(grep -r -H -E --include='*.h' --include='*.cpp' '^ *# *include' lib/sightline)

for folder in lib/sightline/*/; do
  room=${folder#lib/sightline/}
  room=${room%/}
  grep -q "^$room " <<<"$arrows" || violation "room: $room has no line in this test's table of arrows"
done

while IFS= read -r line; do
  file=${line%%:*} lab=${line#labs/}
  lab=${lab%%/*}
  # What all labs share has no number.
  [[ ! $line =~ \"(labs|\.\.)/([0-9][^/\"]*)/ || ${BASH_REMATCH[2]} == "$lab" ]] || violation "include: $file: no lab includes another"
done < <([[ ! -d labs ]] || grep -r -H -E '^ *# *include *"' labs || true)

# ---- Sizes and names

# Two types of one name in one namespace: a compiler never sees both, and the linker keeps one's functions for both.
while IFS= read -r line; do violation "type: $line"; done < <(
  printf '%s\n' "${files[@]}" | grep -E '^(lib|bench|viz|labs/[a-z]+|tests/hard_cases)/.*\.h$' | tr '\n' '\0' | xargs -0 -r awk '
    FNR == 1 { depth = 0 }
    /^namespace[ {]/ { within[++depth] = $2 == "{" ? FILENAME : $2 }
    /^}  \/\/ namespace/ && depth > 0 { --depth }
    /^(struct|class) [A-Za-z0-9_]+ .*{/ {
      name = $2
      for (i = depth; i > 0; --i) name = within[i] "::" name
      if (name in file && file[name] != FILENAME) print name " is defined in " file[name] " and in " FILENAME
      file[name] = FILENAME
    }')

while read -r lines file; do
  ((lines <= longest_file)) || [[ $file == total ]] || violation "size: $file has $lines lines, more than $longest_file"
done < <(wc -l -- "${sources[@]}" /dev/null)
while read -r bytes file; do
  ((bytes <= largest_file)) || violation "size: $file has $bytes bytes, more than $largest_file"
done < <(stat -c '%s %n' -- "${files[@]}")
for file in "${files[@]}"; do
  [[ $top_level == *" ${file%%/*} "* ]] || violation "name: ${file%%/*} does not belong at the top level"
done
for folder in $folders_with_readme; do
  [[ -f $folder/README.md ]] || violation "readme: $folder/README.md is missing"
done
while IFS= read -r line; do
  [[ $line == *:1 ]] || violation "guard: ${line%:*} needs one #pragma once"
done < <(grep -c '^#pragma once$' "${headers[@]}" /dev/null | grep -v '^/dev/null:')

# ---- What no file may contain

matches '\b(TOD[O]|FIXM[E]|X[X]X)\b' unfinished "${files[@]}"
matches '(registry\.npm[j]s|pypi\.[o]rg|deb\.debia[n]\.org)' 'registry host' "${files[@]}"
matches '(^|[^A-Za-z0-9_.}/*~-])/(home|root|work|Users|mnt|media|srv|opt|tmp)/[A-Za-z0-9_]' 'machine path' "${files[@]}"

# Outside comments: numbers below 0.001, and the name itself. Bounds are derived, and written as powers of two.
while IFS= read -r line; do violation "magic epsilon: $line"; done < <(awk '
  {
    code = $0
    sub(/\/\/.*/, "", code)
    gsub(/numeric_limits<[^>]*>::epsilon/, "", code)
    if (code ~ /(^|[^A-Za-z])k?[eE][pP][sS]([iI][lL][oO][nN])?_?([^A-Za-z0-9_]|$)/ ||
        code ~ /(^|[^A-Za-z0-9_.])([0-9]+\.?[0-9]*|\.[0-9]+)[eE]-([3-9]|[1-9][0-9])/ ||
        code ~ /(^|[^A-Za-z0-9_.])0?\.000[0-9]*[1-9]/)
      print FILENAME ":" FNR ": " $0
  }' "${library[@]}" /dev/null)

((violations == 0)) || { echo "$violations violations of the rules of the house"; exit 1; }
