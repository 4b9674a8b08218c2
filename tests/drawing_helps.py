#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that the help of each debug key that draws says where: views list what could be drawn by these words.

Usage: drawing_helps.py PROJECT_FOLDER
"""
import pathlib
import re
import sys

WORDS = {"imageDrawing": "(drawn in the image)", "fieldDrawing": "(drawn on the field)", "robotDrawing": "(drawn around the robot)"}
KEY = re.compile(r'DebugKey\s+(k\w+)\s*\{\s*"[^"]*",\s*((?:"[^"]*"\s*)+)\}')
DRAWING = re.compile(r"\b(imageDrawing|fieldDrawing|robotDrawing)\(\s*(k\w+)")


def main(project):
    texts = {path: path.read_text() for path in sorted((project / "modules").rglob("*")) if path.suffix in (".cpp", ".h")}
    shared = {name: text for path in texts if path.suffix == ".h" for name, text in KEY.findall(texts[path])}
    drawings, problems = 0, []
    for path, text in texts.items():
        helps = {**shared, **dict(KEY.findall(text))}
        for kind, key in DRAWING.findall(text):
            drawings += 1
            if WORDS[kind] not in helps.get(key, ""):
                problems.append(f"{path}: the help of {key} does not end in '{WORDS[kind]}'")
    print("\n".join(problems) if problems else f"{drawings} drawings say where they are drawn")
    return 1 if problems or drawings < 10 else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
