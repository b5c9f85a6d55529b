#!/bin/bash
# Checks sightline-view build from outside: build_test.sh FOLDER_OF_PROGRAMS. Exit 0 when all hold.
set -u
view=$1/sightline-view
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0

fail() {
  echo "FAIL $1"
  failures=$((failures + 1))
}

# expect STATUS PATTERN ARGUMENTS...: exit status, and exactly one line on stderr that matches.
expect() {
  local status=$1 pattern=$2
  shift 2
  "$view" build "$@" >"$folder/stdout" 2>"$folder/stderr"
  local found=$?
  [ $found -eq "$status" ] || fail "'$*': exit $found instead of $status: $(head -1 "$folder/stderr")"
  [ "$(wc -l <"$folder/stderr")" -eq 1 ] || fail "'$*': $(wc -l <"$folder/stderr") lines on stderr"
  grep -qE -- "$pattern" "$folder/stderr" || fail "'$*': no '$pattern' in: $(head -1 "$folder/stderr")"
}

# A run without any display and without Xvfb.
headless() { env -u DISPLAY PATH=/nonexistent "$view" build "$@" 2>>"$folder/log"; }

pot=(--scene teapot:4)

# Usage
expect 2 "accelerator 'octopus'" --accel octopus "${pot[@]}" --out "$folder/a.png"
expect 2 "brute-force: expected one of kd-tree" --accel brute-force "${pot[@]}" --out "$folder/a.png"
expect 2 "\.png \(picture\), \.svg" "${pot[@]}" --out "$folder/a.txt"
expect 2 "--step 99999: expected 0 to 115" "${pot[@]}" --step 99999 --out "$folder/a.csv"
expect 2 "--node 12345: expected the number of a node" "${pot[@]}" --node 12345 --out "$folder/a.csv"
expect 2 "at least 1200x675" "${pot[@]}" --size 640x480 --out "$folder/a.png"
expect 2 "--zoom" "${pot[@]}" --zoom nan --out "$folder/a.png"
expect 2 "neither --out nor --node" "${pot[@]}" --frames "$folder/f" --out "$folder/a.png"
[ -z "$(ls "$folder"/a.* 2>/dev/null)" ] || fail "wrong usage left a file"

# Candidates need no display; the one taken is the cheapest, and the sentence tells it.
for accel in kd-tree bsp-tree grid; do
  headless --accel "$accel" "${pot[@]}" --out "$folder/$accel.csv" || fail "$accel: no csv"
  headless --accel "$accel" "${pot[@]}" --out "$folder/$accel.json" || fail "$accel: no json"
  python3 - "$folder/$accel" <<'END' || fail "$accel: the candidates do not agree"
import csv, json, sys
rows = list(csv.DictReader(open(sys.argv[1] + ".csv")))
told = json.load(open(sys.argv[1] + ".json"))
assert told["divided"] and len(rows) == len(told["candidates"]) > 1
taken = [i for i, row in enumerate(rows) if row["chosen"] == "1"]
assert taken == [told["chosen"]]
assert all(float(row["cost"]) == c["cost"] for row, c in zip(rows, told["candidates"]))
if rows[taken[0]]["label"]: sys.exit()  # a grid goes by a rule
assert float(rows[taken[0]]["cost"]) == min(float(row["cost"]) for row in rows)
assert told["candidates"][taken[0]]["cost"] < (told["leaf_cost"] or 1e9)
END
done
headless "${pot[@]}" --out "$folder/none.png" && fail "a picture without a screen"
tail -1 "$folder/log" | grep -q Xvfb || fail "no word of Xvfb: $(tail -1 "$folder/log")"

# The same bytes again, and from any number of threads.
small=(--size 1200x675)
expect 0 "splits at" "${pot[@]}" --step 3 --out "$folder/one.png" "${small[@]}"
expect 0 "splits at" "${pot[@]}" --step 3 --threads 1 --out "$folder/two.png" "${small[@]}"
cmp -s "$folder/one.png" "$folder/two.png" || fail "two pictures of a step differ"
expect 0 "splits at" "${pot[@]}" --out "$folder/chart.svg"
python3 - "$folder/chart.svg" <<'END' || fail "the chart is not what a browser reads"
import sys, xml.etree.ElementTree as tree
parts = list(tree.parse(sys.argv[1]).iter())
assert len(parts) > 100 and not any("nan" in value for part in parts for value in part.attrib.values())
END
expect 0 "2 pictures" "${pot[@]}" --frames "$folder/frames" --most 2 "${small[@]}"
[ "$(ls "$folder/frames")" = "$(printf 'step-0000.png\nstep-0001.png')" ] || fail "the frames are $(ls "$folder/frames")"

[ $failures -eq 0 ] && echo "build: all well"
[ $failures -eq 0 ]
