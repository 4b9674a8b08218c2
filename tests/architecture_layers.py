#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails, naming file and line, where a folder includes one that the architecture does not let it use.

The table is the one of ARCHITECTURE.md. A file belongs to the longest folder of the table that its path starts with.
Usage: architecture_layers.py SOURCE_DIR
"""
import pathlib
import re
import sys

ROBOTLINK_OF_PROGRAM = ["robotlink/base", "robotlink/config", "robotlink/packages", "robotlink/process",
                        "robotlink/debugging", "robotlink/motions"]
ROBOTLINK = ROBOTLINK_OF_PROGRAM + ["robotlink/session", "robotlink/foxglove", "robotlink/arcos"]

MAY_INCLUDE = {
    "robotlink/base": [],
    "robotlink/config": ["robotlink/base"],
    "robotlink/packages": ["robotlink/base"],
    "robotlink/process": ["robotlink/base", "robotlink/config", "robotlink/packages"],
    "robotlink/debugging": ["robotlink/base", "robotlink/config", "robotlink/packages", "robotlink/process"],
    "robotlink/session": ["robotlink/base", "robotlink/config", "robotlink/packages", "robotlink/process",
                          "robotlink/debugging"],
    "robotlink/motions": ["robotlink/base"],
    "robotlink/arcos": ["robotlink/base"],
    "robotlink/foxglove": ROBOTLINK,
    "simcore": ["robotlink/base"],
    "colortool": ["robotlink/base"],
    "logplayer/mcap": ["robotlink/base"],
    "logplayer": ["logplayer/mcap"] + ROBOTLINK,
    "modules": ["colortool"] + ROBOTLINK_OF_PROGRAM,
    "widgets/models": ["logplayer", "logplayer/mcap", "colortool"] + ROBOTLINK,
    "widgets": ["widgets/models", "logplayer", "logplayer/mcap", "colortool"] + ROBOTLINK,
}
EVERYTHING_BUT_WIDGETS = ["simcore", "colortool", "logplayer", "logplayer/mcap", "modules"] + ROBOTLINK
MAY_INCLUDE["app/core"] = EVERYTHING_BUT_WIDGETS
MAY_INCLUDE["app/robotctl"] = ["app/core"] + EVERYTHING_BUT_WIDGETS
MAY_INCLUDE["app/robotcontrol"] = ["app/core", "widgets", "widgets/models"] + EVERYTHING_BUT_WIDGETS

# Libraries whose headers only some folders may show or use.
OUTSIDE = {
    r"^ode/": ["simcore"],
    r"^embree3/": ["simcore"],
    r"^boost/": ["robotlink/arcos", "robotlink/foxglove"],
    r"^sdf/": ["simcore"],
    r"^(Q[A-Z]\w*|Qt\w*/)": ["widgets", "widgets/models", "app/robotcontrol"],
    r"^(lz4frame|zstd|libdeflate)": ["logplayer/mcap"],
    r"^bzlib": ["colortool"],
    r"^(jpeglib|png)\.h": ["logplayer"],
    r"^(qcustomplot|qtadvanceddocking)": ["widgets", "app/robotcontrol"],
}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def folder_of(path, folders):
    matches = [f for f in folders if path == f or path.startswith(f + "/")]
    return max(matches, key=len) if matches else None


def problems_of(source, relative, folder):
    for number, line in enumerate(source.read_text(errors="replace").splitlines(), 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        included = match.group(2)
        target = folder_of(included, MAY_INCLUDE)
        if target and match.group(1) == '"' and target != folder and target not in MAY_INCLUDE[folder]:
            yield f"{relative}:{number}: {folder} may not include {target} ({included})"
        for pattern, users in OUTSIDE.items():
            if match.group(1) == "<" and re.match(pattern, included) and folder not in users:
                yield f"{relative}:{number}: {folder} may not use <{included}>"


def main():
    root = pathlib.Path(sys.argv[1])
    problems, files = [], 0
    for top in ("app", "widgets", "robotlink", "simcore", "logplayer", "colortool", "modules"):
        for source in sorted((root / top).rglob("*")):
            if source.suffix not in (".h", ".cpp"):
                continue
            files += 1
            relative = source.relative_to(root).as_posix()
            folder = folder_of(relative, MAY_INCLUDE)
            if folder is None:
                problems.append(f"{relative}:1: this folder is not in the table of {pathlib.Path(__file__).name}")
            else:
                problems.extend(problems_of(source, relative, folder))
    print("\n".join(problems) or f"{files} files include only what they may")
    return 1 if problems or files == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
