#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Says which tests were skipped in a run of ctest, and fails if one of them should not have been.

A test may be skipped where npm, GNAT, a network, or an X server for tests is missing, and if skipped.txt lists it: those
need data that is not in the repository. That list may only shrink.
Usage: skipped.py build/release/Testing/Temporary/LastTest.log
"""
import pathlib
import re
import sys

EXCUSES = re.compile(r"\bnpm\b|\bnode\b|GNAT|gnatmake|network|Xvfb|xdotool|AVX2", re.IGNORECASE)
PROGRAM = re.compile(r'^\d+/\d+ Testing: (.+)$', re.MULTILINE)
# How GoogleTest, QtTest and unittest tell that they skip something: with the reason before, after, and after its name.
GOOGLE = re.compile(r"(?:^.*: Skipped\n(?P<reason>(?:(?!\[).*\n)*))?^\[  SKIPPED \] (?P<name>\S+) \(\d+ ms\)$", re.MULTILINE)
QT = re.compile(r"^SKIP   : (?P<name>\S+?)\(.*?\) (?P<reason>.*)$", re.MULTILINE)
UNITTEST = re.compile(r"^(?P<name>\w+) \(.*\) \.\.\. skipped (?P<reason>.*)$", re.MULTILINE)


def skipped_in(log):
    """(program, test, reason) of all that was skipped."""
    parts = PROGRAM.split(log)
    for program, output in zip(parts[1::2], parts[2::2]):
        for pattern in (GOOGLE, QT, UNITTEST):
            for match in pattern.finditer(output):
                yield program, match["name"], (match["reason"] or "").strip()


def main():
    log = pathlib.Path(sys.argv[1])
    path = pathlib.Path(__file__).with_suffix(".txt")
    listed = {tuple(line.split()) for line in path.read_text().splitlines() if line and not line.startswith("#")}
    text = log.read_text(errors="replace")
    if not PROGRAM.search(text):
        print(f"{log} tells of no test")
        return 1
    skipped = list(skipped_in(text))
    wrong = [one for one in skipped if not EXCUSES.search(one[2]) and one[:2] not in listed]
    print(f"{len(skipped)} tests were skipped, {len(wrong)} of them must not be")
    for program, name, reason in wrong:
        print(f"  {program} {name}: {reason or 'without a reason'}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
