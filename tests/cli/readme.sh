#!/usr/bin/env bash
# Runs each command of the README, in an empty folder, with programs that are built already.
# usage: readme.sh FOLDER_OF_PROGRAMS [README]
# shellcheck source=tests/cli/lib.sh disable=SC2016
source "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"
SIGHTLINE_BIN=$(realpath -- "${1:?usage: readme.sh FOLDER_OF_PROGRAMS [README]}")
export SIGHTLINE_BIN
readme=${2:-$root/README.md}

# Of each ```sh block the lines that start with this project's commands, without comments, continued lines joined.
commands=()
while IFS= read -r line; do
  commands+=("$line")
done < <(sed -n '/^ *```sh *$/,/^ *```$/p' "$readme" | sed -e ':a; /\\$/N; s/\\\n */ /; ta' |
  sed -e 's/^ *\$ //; s/^ *//; s/ \+#.*//' | grep -E '^(\./sightline|data/fetch)( |$)' | sort -u)
status=0 ran=$readme
: >"$scratch/stderr"
check 'commands in the README' test "${#commands[@]}" -gt 0

mkdir -p "$work"
for line in "${commands[@]}"; do
  [[ -n $(compgen -G "$root/data/cache/*dragon*") ]] || line=$(sed -E 's/dragon(:[0-9]+)?/teapot/' <<<"$line")
  read -r -a words <<<"$line"
  case "${words[*]:0:2} " in
    './sightline test ') words=("${words[@]:0:2}" --help) ;; # this is that command, and would run itself for ever
    './sightline tour ') [[ $line == *--out* ]] || words+=(--out tour) ;;
    './sightline view ') [[ $line == *--out* || $line == *--html* ]] || words+=(--out window.vtp) ;;
    './sightline scenes ') [[ ${#words[@]} -gt 2 ]] || words+=(--out scenes --size 64x48)
      words=("${words[@]/#data\//$root/data/}") ;;
    './sightline render ' | './sightline plan ') words=("${words[@]/#data\//$root/data/}") ;;
    './sightline probe ' | './sightline noise ') words=("${words[@]/#data\//$root/data/}") ;;
    './sightline stability ') [[ $line == *--explain* ]] || words+=(--group build) ;;
    './sightline bench ') [[ $line == *--quick* ]] || words+=(--quick) ;;
    './sightline accuracy ') [[ $line == *--axis* ]] || words+=(--axis box --quick --rounds 3) ;;
    './sightline claims ') [[ $line == *--claim* ]] || words+=(--claim grid_cells --rounds 3) ;;
  esac
  for word in "${words[@]:1}"; do
    [[ $word != */*.* || $word == /* ]] || mkdir -p "$work/$(dirname -- "$word")"
  done
  run_again "$root/${words[0]#./}" "${words[@]:1}"
  if [[ ${words[*]} == *fetch* && $status != 0 ]]; then
    expect_exit 1 # without a network: said in one line
    expect_one_line
  else
    expect_exit 0
  fi
done
finish
