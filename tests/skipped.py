#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Says which tests were skipped in a run of ctest, and fails if one of them should not have been.

A test may be skipped where npm, GNAT, a network, or an X server for tests is missing, or if skipped.txt lists it with its
sibling: it takes data that are not in the repository, and the sibling tests the same on data that are. The sibling must have
passed in the same run, and what the list names must exist. That list may only shrink.
Usage: skipped.py build/release/Testing/Temporary/LastTest.log
"""
import pathlib
import re
import sys

EXCUSES = re.compile(r"\bnpm\b|\bnode\b|GNAT|gnatmake|network|Xvfb|xdotool|AVX2|slurmctld", re.IGNORECASE)
PROGRAM = re.compile(r'^\d+/\d+ Testing: (.+)$', re.MULTILINE)
# How GoogleTest, QtTest and unittest tell that they skip something: with the reason before, after, and after its name.
SKIPPED = [
    re.compile(r"(?:^.*: Skipped\n(?P<reason>(?:(?!\[).*\n)*))?^\[  SKIPPED \] (?P<name>\S+) \(\d+ ms\)$", re.MULTILINE),
    re.compile(r"^SKIP   : (?P<name>\S+?\(.*?\)) (?P<reason>.*)$", re.MULTILINE),
    re.compile(r"^(?P<name>\w+) \(.*\) \.\.\. skipped (?P<reason>.*)$", re.MULTILINE)]
# How they tell that it passed.
PASSED = [re.compile(r"^\[       OK \] (\S+) \(\d+ ms\)$", re.MULTILINE), re.compile(r"^PASS   : (\S+?\(.*?\))$", re.MULTILINE),
          re.compile(r"^(\w+) \(.*\) \.\.\. ok$", re.MULTILINE)]


def read(log):
    """The programs of a run, (program, test, reason) of all that was skipped, and (program, test) of all that passed."""
    parts = PROGRAM.split(log)
    programs, skipped, passed = set(parts[1::2]), [], set()
    for program, output in zip(parts[1::2], parts[2::2]):
        skipped += [(program, match["name"].removesuffix("()"), (match["reason"] or "").strip())
                    for pattern in SKIPPED for match in pattern.finditer(output)]
        passed |= {(program, name.removesuffix("()")) for pattern in PASSED for name in pattern.findall(output)}
    return programs, skipped, passed


def siblings_in(path):
    """The sibling (program, test) of each test in the list, by the same."""
    siblings = {}
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if not line or line.startswith("#"):
            continue
        words = line.split()
        if len(words) != 4:
            sys.exit(f"{path}:{number}: a line has a program and its test, and the program and test of the sibling")
        siblings[tuple(words[:2])] = tuple(words[2:])
    return siblings


def main():
    log = pathlib.Path(sys.argv[1])
    siblings = siblings_in(pathlib.Path(__file__).with_suffix(".txt"))
    programs, skipped, passed = read(log.read_text(errors="replace"))
    if not programs:
        print(f"{log} tells of no test")
        return 1
    problems = [f"{program} {name} must not be skipped: {reason or 'without a reason'}"
                for program, name, reason in skipped if not EXCUSES.search(reason) and (program, name) not in siblings]
    known = passed | {(program, name) for program, name, _ in skipped}
    for test, sibling in siblings.items():
        if test[0] not in programs:
            continue
        if test not in known:
            problems.append(f"{' '.join(test)}, which skipped.txt lists, did not run")
        if sibling not in passed:
            problems.append(f"{' '.join(sibling)}, the sibling of {' '.join(test)}, did not pass")
    print(f"{len(skipped)} tests were skipped, {len(siblings)} tests that may be have siblings, {len(problems)} problems")
    for problem in problems:
        print(f"  {problem}")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
