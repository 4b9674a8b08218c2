#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails, naming file and line, where a test can check nothing: its body, and the functions of its file that it calls,
have no expectation.

A test checks by GoogleTest's EXPECT and ASSERT, by QtTest's QVERIFY, QCOMPARE and QTRY, by FAIL or ADD_FAILURE, or by a
function that another file has and whose name says that it does: expect..., verify..., check..., fuzz....
Usage: empty_tests.py SOURCE_DIR
"""
import pathlib
import re
import sys

CHECK = re.compile(r"\b(EXPECT_\w+|ASSERT_\w+|QVERIFY\w*|QCOMPARE\w*|QTRY_\w+|QFAIL|FAIL|ADD_FAILURE|SUCCEED|static_assert|"
                   r"TRUTH\w*|(expect|verify|check|compare|require|fuzz|mutate)\w*)\s*(\(|<)", re.IGNORECASE)
TEST = re.compile(r"^(?:TEST|TEST_F|TEST_P|TYPED_TEST)\(\s*(\w+),\s*(\w+)\)\s*\{", re.M)
FUNCTION = re.compile(r"^[ \t]*(?:static |inline |\[\[nodiscard\]\] |template <[^\n]*>\n)*[\w:<>,&*\[\] ]+?\b(\w+)\([^;{}]*\)[^;{}()]*\{", re.M)
CALL = re.compile(r"\b(\w+)\s*\(")


def body(text, opening):
    """The text from an opening brace to the one that closes it; braces in strings are as good as balanced."""
    depth = 0
    for index in range(opening, len(text)):
        if text[index] == "{":
            depth += 1
        elif text[index] == "}":
            depth -= 1
            if depth == 0:
                return text[opening:index + 1]
    return text[opening:]


def without_literals(text):
    text = re.sub(r'R"\((?:.|\n)*?\)"', '""', text)
    text = re.sub(r'"(?:\\.|[^"\\\n])*"', '""', text)
    text = re.sub(r"'(?:\\.|[^'\\\n])'", "' '", text)
    return re.sub(r"//[^\n]*", "", text)


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    problems, count = [], 0
    for source in sorted((root / "tests").rglob("*.cpp")):
        text = without_literals(source.read_text(errors="replace"))
        functions = {}
        for match in FUNCTION.finditer(text):
            functions.setdefault(match.group(1), []).append(body(text, match.end() - 1))

        def checks(part, seen):
            if CHECK.search(part):
                return True
            for name in set(CALL.findall(part)) - seen:
                seen.add(name)
                if any(checks(inner, seen) for inner in functions.get(name, [])):
                    return True
            return False

        for match in TEST.finditer(text):
            count += 1
            if match.group(2).startswith("DISABLED_"):  # run by hand, for what they print
                continue
            if not checks(body(text, match.end() - 1), set()):
                line = text.count("\n", 0, match.start()) + 1
                problems.append(f"{source.relative_to(root).as_posix()}:{line}: {match.group(1)}.{match.group(2)} checks nothing")
    print("\n".join(problems) or f"{count} tests check something")
    return 1 if problems or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
