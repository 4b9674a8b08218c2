#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that texts which count say "1 packet" and "2 packets": each is chosen by counted() of widgets/Counted.h, and none by
%n, which needs a translation file even for English.

Usage: plural_texts.py PROJECT_FOLDER
"""
import pathlib
import re
import sys

LITERALS = r'((?:"(?:[^"\\]|\\.)*"\s*)+)'
TEXT = re.compile(r"\b(?:tr|QT_TR_NOOP|QT_TRANSLATE_NOOP)\(\s*" + LITERALS)
LITERAL = re.compile(r'"((?:[^"\\]|\\.)*)"')
# What texts count. "3 of 7 packets" is right whatever the numbers are.
NOUNS = """bookmarks bytes cells channels checksums chunks classes columns commands drawings errors files frames images keys lines
logs messages names packages packets pictures pixels points problems requests robots rows samples scenes seconds solutions steps
streams strokes tables tasks texts times values views""".split()
# Texts of the colors' views are still to be mended.
LATER = pathlib.Path("widgets/color")
SEVERAL = re.compile(r"(?<!of )%(?:n|L?\d+) (?:more |other |whole )?(?:" + "|".join(NOUNS) + r")\b(?!/s)")  # not rates


def is_counted(before):
    """Whether a call to counted() is open at the end of this text."""
    at = before.rfind("counted(")
    if at < 0:
        return False
    call = re.sub(LITERALS, "", before[at:])
    return call.count("(") > call.count(")")


def problems_of(path, source):
    for match in TEXT.finditer(source):
        text = "".join(LITERAL.findall(match.group(1)))
        line = source.count("\n", 0, match.start()) + 1
        if "%n" in text:
            yield f'{path}:{line}: "{text}" has a %n; write counted(number, tr("1 ..."), tr("%1 ..."))'
        elif SEVERAL.search(text) and not is_counted(source[max(0, match.start() - 600):match.start()]):
            yield f'{path}:{line}: "{text}" may count one thing; write counted(number, tr("1 ..."), tr("%1 ..."))'


def main(project):
    paths = [path for folder in ("app", "widgets") for path in sorted((project / folder).rglob("*")) if path.suffix in (".cpp", ".h")]
    sources = {path.relative_to(project): path.read_text() for path in paths}
    texts = sum(len(TEXT.findall(source)) for source in sources.values())
    problems = [problem for path, source in sources.items() if LATER not in path.parents for problem in problems_of(path, source)]
    print("\n".join(problems) if problems else f"{texts} texts count as people do")
    return 1 if problems or texts < 500 else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
