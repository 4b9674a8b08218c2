#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Decodes the same messages with npm's @foxglove/rosmsg2-serialization and with RosType, and prints the times of one
# message in ns: of npm, whose messages refer to the buffer that was decoded; of npm with copies, which may outlive it; of
# RosType, whose messages always may. Needs node with the packages that ros_messages.mjs names, and the target robotlink_ros_benchmark.
# Usage: compare_decoding.sh [BUILD_FOLDER]
set -euo pipefail
here="$(cd "$(dirname "$0")" && pwd)"
build="${1:-$here/../../../build/release}"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
node "$here/ros_messages.mjs" "$folder" | sort > "$folder/npm"
"$(find "$build" -name robotlink_ros_benchmark -type f | head -1)" "$folder" | sort > "$folder/ours"
printf '%-12s %8s %9s %12s %7s\n' message bytes npm "npm, copied" ours
join "$folder/npm" "$folder/ours" | while read -r name npm copied ours; do
  printf '%-12s %8d %9d %12d %7d\n' "$name" "$(stat -c %s "$folder/$name.cdr")" "$npm" "$copied" "$ours"
done
