#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails, naming file and line, where a comment begins with a word that stands for a noun or has none: a reader should not
have to look at the code to know what a comment is about. "What is known of a ball" is "The state of a ball".
Usage: plain_comments.py SOURCE_DIR
"""
import pathlib
import re
import sys

BEGINNING = re.compile(r"\s*///? (What|Those|They|It|That|Whose|Who|Somebody|Nobody|Such|Of|As many|To be called)\b")


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    problems, count = [], 0
    for top in ("app", "widgets", "robotlink", "simcore", "logplayer", "colortool", "modules"):
        for source in sorted((root / top).rglob("*")):
            if source.suffix not in (".h", ".cpp"):
                continue
            inside = False
            for number, line in enumerate(source.read_text(errors="replace").splitlines(), 1):
                is_comment = line.lstrip().startswith("//")
                count += is_comment
                if is_comment and not inside and BEGINNING.match(line):
                    problems.append(f"{source.relative_to(root).as_posix()}:{number}: name the subject: {line.strip()}")
                inside = is_comment
    print("\n".join(problems) or f"{count} lines of comments begin plainly")
    return 1 if problems or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
