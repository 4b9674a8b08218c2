#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails where a program of tests has one that no test of ctest runs.

Programs that hold the tests of several folders are run once for each, with a filter that CMake makes from the sources
(robotcontrol_filter()).
Usage: forgotten.py BUILD_DIR CTEST
"""
import collections
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile


def tests_of(program):
    """The full names of the tests that a GoogleTest program has."""
    listed = subprocess.run([program, "--gtest_list_tests"], capture_output=True, text=True, check=True).stdout
    names, suite = set(), ""
    for line in listed.splitlines():
        name = line.split("#")[0].strip()
        if line.startswith("  "):
            names.add(suite + name)
        elif name.endswith("."):
            suite = name
    return names


def left_by(text, names):
    """The names that a filter leaves; GoogleTest would say so, too, but each program takes a moment to start."""
    def matches(patterns):
        choices = (re.escape(pattern).replace(r"\*", ".*").replace(r"\?", ".") for pattern in patterns.split(":") if pattern)
        return re.compile("|".join(choices) or r"(?!)").fullmatch
    wanted, _, unwanted = text.partition("-")
    is_wanted, is_unwanted = matches(wanted or "*"), matches(unwanted)
    return {name for name in names if is_wanted(name) and not is_unwanted(name)}


def tests_known_to(ctest, build):
    """Asks from another folder: in its own, ctest would begin the log of its last run again, even while one is under way."""
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, "CTestTestfile.cmake").write_text(f'subdirs("{pathlib.Path(build).resolve().as_posix()}")\n')
        return json.loads(subprocess.run([ctest, "--test-dir", folder, "--show-only=json-v1"], capture_output=True,
                                         text=True, check=True).stdout)["tests"]


def main():
    build, ctest = sys.argv[1:]
    filters = collections.defaultdict(list)
    for test in tests_known_to(ctest, build):
        for argument in test.get("command", []):
            if argument.startswith("--gtest_filter="):
                filters[test["command"][0]].append(argument.partition("=")[2])
    forgotten, count = [], 0
    for program, texts in sorted(filters.items()):
        if not os.path.exists(program):
            continue
        every = tests_of(program)
        count += len(every)
        run = set().union(*(left_by(text, every) for text in texts))
        forgotten += [f"{os.path.basename(program)}: {name}" for name in sorted(every - run)]
    print("\n".join(forgotten) or f"all {count} tests of {len(filters)} programs are run")
    return 1 if forgotten else 0


if __name__ == "__main__":
    sys.exit(main())
