#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails where units (a header and its source) include each other in a circle, unless include_cycles.txt lists that circle.

The list may only shrink: --update writes it again, but refuses to add to it; --strict also fails where it lists too much.
Usage: include_cycles.py SOURCE_DIR [--strict | --update]
"""
import pathlib
import re
import sys

FOLDERS = ("app", "colortool", "logplayer", "modules", "robotlink", "simcore", "widgets")
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)
HEAD = """# Units that include each other in a circle, a circle a line. This list may only shrink; see include_cycles.py.
"""


def units_of(root):
    """What each unit includes, by their paths without suffixes."""
    files = {}
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in (".h", ".cpp"):
                files[path.relative_to(root).as_posix()] = INCLUDE.findall(path.read_text(errors="replace"))
    includes = {}
    for name, included in files.items():
        unit = name.rsplit(".", 1)[0]
        beside = name.rsplit("/", 1)[0]
        for header in included:
            for candidate in (header, f"{beside}/{header}"):
                if candidate in files:
                    includes.setdefault(unit, set()).add(candidate.rsplit(".", 1)[0])
                    break
        includes.setdefault(unit, set()).discard(unit)
    return includes


def circles_of(includes):
    """The strongly connected components of more than one unit (Tarjan), each a sorted tuple."""
    order, low, stack, found = {}, {}, [], []

    def visit(start):
        work = [(start, iter(sorted(includes[start])))]
        order[start] = low[start] = len(order)
        stack.append(start)
        while work:
            unit, rest = work[-1]
            target = next(rest, None)
            if target is None:
                work.pop()
                if work:
                    low[work[-1][0]] = min(low[work[-1][0]], low[unit])
                if low[unit] == order[unit]:
                    place = stack.index(unit)
                    if len(stack) - place > 1:
                        found.append(tuple(sorted(stack[place:])))
                    del stack[place:]
            elif target not in order:
                order[target] = low[target] = len(order)
                stack.append(target)
                work.append((target, iter(sorted(includes[target]))))
            elif target in stack:
                low[unit] = min(low[unit], order[target])

    for unit in sorted(includes):
        if unit not in order:
            visit(unit)
    return sorted(found)


def listed_in(path):
    lines = path.read_text().splitlines() if path.exists() else []
    return [tuple(line.split()) for line in lines if line and not line.startswith("#")]


def problems_of(circles, listed, includes):
    """Circles that are no part of a listed one, each with what of it includes what."""
    for circle in circles:
        if any(set(circle) <= set(known) for known in listed):
            continue
        edges = [f"    {unit} includes {other}" for unit in circle for other in sorted(includes[unit] & set(circle))]
        yield "these units include each other in a circle:\n" + "\n".join(edges)


def main():
    root = pathlib.Path(sys.argv[1])
    path = pathlib.Path(__file__).with_suffix(".txt")
    includes = units_of(root)
    circles = circles_of(includes)
    listed = listed_in(path)
    problems = list(problems_of(circles, listed, includes))
    if not includes:
        problems.append(f"there are no sources in {root}")
    if "--update" in sys.argv and not problems:
        path.write_text(HEAD + "".join(" ".join(circle) + "\n" for circle in circles))
        listed = circles
    gone = [known for known in listed if known not in circles]
    for known in gone:
        print(f"{path.name} lists more than there is: {' '.join(known)}; run {pathlib.Path(__file__).name} SOURCE_DIR --update")
    print("\n".join(problems) or f"{len(includes)} units, {len(circles)} known circles of {sum(map(len, circles))} units")
    return 1 if problems or (gone and "--strict" in sys.argv) else 0


if __name__ == "__main__":
    sys.exit(main())
