#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# fuzz.sh FOLDER SECONDS: runs every libFuzzer program of a folder for so long. What they find to be worth keeping stays in
# corpus/ beside the folder for the next time; inputs that break a program stay in broken/. Fails if there is one.
# fuzz.sh --keep FOLDER NAME FILE: of the fewest inputs of the corpus of the target NAME that reach what all do, writes the 300 shortest
# into FILE, which is corpus/NAME.txt beside the target's CMakeLists.txt: FuzzDriver.cpp then runs them in every build.
set -euo pipefail
if [ "$1" = --keep ]; then
  corpus=$(dirname "$(readlink -f "$2")")/corpus/$3
  few=$(mktemp -d)
  trap 'rm -rf "$few"' EXIT
  "$2/$3_libfuzzer" -set_cover_merge=1 -max_len=1000 -verbosity=0 "$few" "$corpus" 2>/dev/null
  for input in "$few"/*; do od -An -v -tx1 "$input" | tr -d ' \n'; echo; done | LC_ALL=C sort -u |
    awk '{print length($0) " " $0}' | LC_ALL=C sort -n -s | awk 'NR <= 300 {print $2}' >"$4"
  exit
fi
programs=("$1"/*_libfuzzer)
[ -x "${programs[0]}" ] || { echo "There are no fuzzing programs in $1" >&2; exit 1; }
folder=$(dirname "$(readlink -f "$1")")
failed=()
for program in "${programs[@]}"; do
  name=$(basename "$program" _libfuzzer)
  corpus=$folder/corpus/$name
  broken=$folder/broken/$name
  mkdir -p "$corpus" "$broken"
  "$1/${name}_fuzz" --write-seeds "$corpus" >/dev/null
  echo "Fuzzing $name for $2 s"
  "$program" -max_total_time="$2" -timeout=30 -rss_limit_mb=4096 -print_final_stats=1 -verbosity=0 -artifact_prefix="$broken/" \
    "$corpus" >"$broken/log" 2>&1 || { failed+=("$name"); tail -n 40 "$broken/log" >&2; }
  awk '/number_of_executed_units/ {print "  " $2 " inputs"}' "$broken/log"
done
if [ ${#failed[@]} -gt 0 ]; then
  echo "These failed: ${failed[*]}; the inputs are below $folder/broken" >&2
  exit 1
fi
