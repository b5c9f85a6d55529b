#!/usr/bin/env bash
# The script ./sightline, with everything that it calls replaced: what it says, installs, configures, builds and runs.
# shellcheck source=tests/cli/lib.sh disable=SC2016
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

# ---- As it is

run "$root/sightline" help
expect_exit 0
expect_quiet
for name in tour test bench accuracy claims view probe noise scenes stability render plan doctor help; do expect_prints "  $name "; done
run "$root/sightline" --help
expect_exit 0
run "$root/sightline"
expect_exit 0
refuses 2 "did you mean 'bench'" "$root/sightline" bnech
refuses 2 "did you mean 'doctor'" "$root/sightline" doc
refuses 2 'unknown command' "$root/sightline" ''
refuses 2 'unknown command' "$root/sightline" 'b*'
refuses 2 'unknown command' "$root/sightline" help nothing
refuses 2 "unexpected 'x'" "$root/sightline" doctor x
refuses 2 'expected a scene' "$root/sightline" plan
for ranks in '' 0 x -1 1.5; do
  refuses 2 '--mpi: expected a number of processes' "$root/sightline" render teapot --mpi "$ranks"
  refuses 2 '--mpi: expected a number of processes' "$root/sightline" render "--mpi=$ranks" teapot
done
refuses 2 '--mpi: expected a number of processes' "$root/sightline" render teapot --mpi
refuses 2 "unexpected 'view'" "$root/sightline" help bench view
refuses 2 "unexpected 'x'" "$root/sightline" --help bench x
refuses 2 "unexpected 'x'" "$root/sightline" --version x
for flag in --version -v; do
  run "$root/sightline" "$flag"
  expect_exit 0
  expect_quiet
  check 'the version of CMakeLists.txt' grep -q "^project(sightline VERSION $(sed -n 's/^sightline //p' "$scratch/stdout") " "$root/CMakeLists.txt"
done
refuses 2 'unknown preset' "$root/sightline" test --preset fast
refuses 2 'unknown preset' "$root/sightline" test --preset
for name in test doctor fetch help; do
  run "$root/sightline" "$name" --help
  expect_exit 0
  expect_quiet
  expect_prints 'usage: ./sightline'
  expect_no_file
done
run "$root/sightline" doctor
expect_exit 0
expect_quiet
for word in compiler cmake processor cores memory vectors display data Embree VTK tour; do expect_prints "$word"; done
ln -s "$root/sightline" "$scratch/link"
run "$scratch/link" help
expect_exit 0

# ---- On machines that lack things

house=$scratch/a\ house
tools=$scratch/tools
mkdir -p "$house" "$tools"
cp "$root/sightline" "$house/"

# replace PROGRAM LINES: a program of this name on the PATH, and no other.
replace() {
  rm -f -- "$tools/$1"
  printf '#!/bin/bash\n%s\n' "$2" >"$tools/$1"
  chmod +x "$tools/$1"
}
for tool in bash env id chmod dirname readlink cat grep sed sort tail head wc cut mkdir rm tr nproc awk uname stty; do
  ln -s "$(type -P "$tool")" "$tools/$tool"
done
on_machine() { run env -i PATH="$tools" HOME="$scratch" LOG="$scratch/log" "$@"; }
calls() { check "a call: $1" grep -q -F -e "$1" "$scratch/log"; }
no_call() { check "no call of $1" bash -c "! grep -q '^$1' '$scratch/log' 2>/dev/null"; }

on_machine "$house/sightline" doctor
expect_exit 0
expect_quiet
expect_prints 'not installed'

for name in tour bench view; do
  for asked in "$name --help" "help $name" "$name -h"; do
    # shellcheck disable=SC2086 # two words
    on_machine "$house/sightline" $asked
    expect_exit 0
    expect_one_line
    expect_says 'the full help comes from the program'
    expect_prints "usage: ./sightline $name"
    expect_prints --scene
    check 'one help only' test "$(grep -c usage: "$scratch/stdout")" = 1
  done
done
on_machine "$house/sightline" probe --help
expect_exit 0
expect_one_line
expect_prints 'usage: ./sightline probe'
expect_prints --precision
check 'nothing built' test ! -e "$house/build"

replace id 'echo 1000'
on_machine "$house/sightline" bench
expect_exit 1
expect_one_line
expect_says 'not Debian'

replace dpkg-query 'exit 1'
replace apt-get 'echo "apt-get $*" >>"$LOG"; echo "E: Could not resolve the host"; exit 100'
on_machine "$house/sightline" bench
expect_exit 1
expect_one_line
expect_says 'neither root nor sudo'
expect_says 'libembree-dev'
no_call apt-get

replace id 'echo 0'
on_machine "$house/sightline" bench
expect_exit 1
expect_says 'offline?'
expect_says 'Could not resolve the host'
expect_no_output

replace id 'echo 1000'
replace sudo 'echo "sudo: a password is required" >&2; exit 1'
on_machine "$house/sightline" bench
expect_exit 1
expect_says 'a password is required'

# ---- On a machine where all goes well

rm -f "$scratch/log"
replace sudo 'echo "sudo $*" >>"$LOG"; [[ $1 != -n ]] || shift; exec "$@"'
replace apt-get 'echo "apt-get $*" >>"$LOG"; echo Unpacking'
replace cmake 'echo "cmake $*" >>"$LOG"
case $1 in
  -S)
    mkdir -p "$2/build/$4/bin"
    : >"$2/build/$4/build.ninja"
    { echo "CMAKE_HOME_DIRECTORY:INTERNAL=$2"; printf "%s:BOOL=ON\n" "${@:5}" | sed "s/^-D//; s/=ON:/:/"; } >"$2/build/$4/CMakeCache.txt" ;;
  --build)
    for target in "${@:6}"; do
      printf "#!/bin/bash\nprintf \"<%%s>\" \"\$@\"; echo at \"\$PWD\"; exit 7\n" >"$2/bin/$target"
      chmod +x "$2/bin/$target"
    done ;;
esac'
on_machine "$house/sightline" bench 'two words' --option=3
expect_exit 7
expect_prints "<two words><--option=3>at $work"
expect_says "'bench' needs Debian packages that are not installed"
expect_says 'libembree-dev'
calls 'sudo -n env DEBIAN_FRONTEND=noninteractive apt-get -y'
calls 'install --no-install-recommends'
calls '--preset release -DSIGHTLINE_BENCH=ON'
calls '--target sightline-bench'
no_call 'cmake.*VIZ'
expect_no_file

replace dpkg-query 'for package; do [[ $package == -* || $package == \$* ]] || echo "$package installed"; done'
for program in g++ ninja pkg-config Xvfb npm; do replace "$program" exit; done
rm -f "$scratch/log"
on_machine "$house/sightline" view partitions
expect_exit 7
expect_prints '<partitions>'
no_call apt-get
calls '-DSIGHTLINE_VIZ=ON'
calls '--target sightline-view'

printf 'SIGHTLINE_VIZ:BOOL=ON\n' >>"$house/build/release/CMakeCache.txt"
rm -f "$scratch/log"
on_machine "$house/sightline" view --help
expect_exit 7
expect_prints '<--help>'
no_call cmake
on_machine "$house/sightline" help view
expect_exit 7
expect_prints '<--help>'
no_call cmake

mkdir -p "$house/data"
printf '#!/bin/bash\necho fetch >>"$LOG"; exit 1\n' >"$house/data/fetch"
chmod +x "$house/data/fetch"
on_machine "$house/sightline" tour
expect_exit 7
calls fetch
expect_says 'without the dragon'
expect_prints "<--out><$house/out/tour>"
on_machine "$house/sightline" tour --out here
expect_prints '<--out><here>'
on_machine "$house/sightline" fetch
expect_exit 1

mv "$house" "$scratch/moved"
rm -f "$scratch/log"
on_machine "$scratch/moved/sightline" bench
expect_exit 7
expect_says 'made for another folder'
calls 'cmake -S'

replace cmake 'echo "[1/2] fine"; echo "[2/2] bad"; echo "FAILED: bad.o"; echo "bad.cpp:1: error: bad"; exit 1'
on_machine "$scratch/moved/sightline" bench
expect_exit 1
expect_says 'bad.cpp:1: error: bad'
expect_says 'building failed'
check 'only what concerns the error' bash -c "! grep -q fine '$scratch/stderr'"

replace ctest 'echo "ctest $*"; exit 8'
on_machine env SIGHTLINE_BIN="$scratch" "$scratch/moved/sightline" test -R house --preset=tsan
expect_exit 1
expect_prints "--test-dir $scratch/moved/build/tsan --output-on-failure"
expect_prints '-R house'
finish
