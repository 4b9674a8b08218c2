#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# fuzz.sh FOLDER SECONDS: runs every libFuzzer program of a folder for so long. What they find to be worth keeping stays in
# corpus/ beside the folder for the next time; inputs that break a program stay in broken/. Fails if there is one.
# fuzz.sh --keep FOLDER NAME FILE: of the fewest inputs of the corpus of the target NAME that reach what all do, writes the 300 shortest
# into FILE, which is tests/fuzz/corpus/NAME.txt: FuzzDriver.cpp then runs them in every build.
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
folder=$(dirname "$(readlink -f "$1")")
failed=()
# fuzz_target DRIVER NAME SECONDS
fuzz_target() {
  local program corpus=$folder/corpus/$2 broken=$folder/broken/$2
  program=$(dirname "$1")/$2_libfuzzer
  mkdir -p "$corpus" "$broken"
  "$1" "$2" --write-seeds "$corpus" >/dev/null
  echo "Fuzzing $2 for $3 s"
  "$program" -max_total_time="$3" -timeout=30 -rss_limit_mb=4096 -print_final_stats=1 -verbosity=0 -artifact_prefix="$broken/" \
    "$corpus" >"$broken/log" 2>&1 || { failed+=("$2"); tail -n 40 "$broken/log" >&2; }
  awk '/number_of_executed_units/ {print "  " $2 " inputs"}' "$broken/log"
}
drivers=("$1"/*_fuzz)
[ -x "${drivers[0]}" ] || { echo "There are no fuzzing programs in $1" >&2; exit 1; }
for driver in "${drivers[@]}"; do
  for name in $("$driver" --list); do fuzz_target "$driver" "$name" "$2"; done
done
if [ ${#failed[@]} -gt 0 ]; then
  echo "These failed: ${failed[*]}; the inputs are below $folder/broken" >&2
  exit 1
fi
