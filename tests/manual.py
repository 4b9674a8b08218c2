#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks the manual in resources/manual: each view of the source has a page with its title, each link leads to a page, each
page is reached from index.md, and no line is over 200 characters.

Usage: manual.py PROJECT_FOLDER
"""
import pathlib
import re
import sys

MAX_LINE = 200
FIRST = "index.md"
VIEW = re.compile(r'\bViewRegistration\s+k\w+\s*\{\s*\{\s*"([\w-]+)",\s*QT_TRANSLATE_NOOP\(\s*"[^"]*",\s*"([^"]*)"\)')
VIEWS_AT_ALL = re.compile(r"\bViewRegistration\s+k\w+\s*\{")
LINK = re.compile(r"\[[^\]]*\]\(([^)]*)\)")
CODE = re.compile(r"^```.*?^```|`[^`\n]*`", re.MULTILINE | re.DOTALL)


def views_of(source):
    """The titles of all views that this source registers, by id."""
    views = dict(VIEW.findall(source))
    if len(views) != len(VIEWS_AT_ALL.findall(source)):
        raise ValueError("a ViewRegistration that is not understood")
    return views


def links_of(page):
    """Where the links of a page lead, those in code left out."""
    return LINK.findall(CODE.sub("", page))


def reached_from_first(pages):
    """The names of the pages that are reached from the first one by links."""
    reached, new = set(), {FIRST} & set(pages)
    while new:
        reached |= new
        new = {link for page in new for link in links_of(pages[page]) if link in pages} - reached
    return reached


def problems_of(pages, views):
    """What is wrong with the pages (texts by file name), a line each."""
    problems = [] if FIRST in pages else [f"{FIRST}: is missing"]
    for view, title in sorted(views.items()):
        page = pages.get(f"{view}.md")
        if page is None:
            problems.append(f"{view}.md: the view {title} has no page")
        elif not page.startswith(f"# {title}\n"):
            problems.append(f"{view}.md:1: does not begin with the view's title, # {title}")
    for name, page in sorted(pages.items()):
        problems += [f"{name}: links to {link}, which is no page" for link in links_of(page) if link not in pages]
        problems += [f"{name}:{number}: has {len(line)} characters, more than {MAX_LINE}"
                     for number, line in enumerate(page.splitlines(), 1) if len(line) > MAX_LINE]
    return problems + [f"{name}: is not reached from {FIRST}" for name in sorted(set(pages) - reached_from_first(pages))]


def check_itself():
    """Raises AssertionError if one of the checks would find nothing."""
    views = {"plots": "Plots"}
    good = {FIRST: "[Plots](plots.md)", "plots.md": "# Plots\n`[a](b)`"}
    assert problems_of(good, views) == []
    assert problems_of({FIRST: ""}, views) == ["plots.md: the view Plots has no page"]
    assert len(problems_of(good | {"plots.md": "# Curves\n"}, views)) == 1
    assert len(problems_of(good | {"plots.md": "# Plots\n[x](y.md)"}, views)) == 1
    assert len(problems_of(good | {"lost.md": "# Lost\n"}, views)) == 1
    assert len(problems_of(good | {"plots.md": "# Plots\n" + "x" * (MAX_LINE + 1)}, views)) == 1
    assert len(problems_of({"plots.md": "# Plots\n"}, views)) == 2
    assert views_of('const ViewRegistration kA{\n {"a-b", QT_TRANSLATE_NOOP("View", "A b"),') == {"a-b": "A b"}


def main():
    check_itself()
    root = pathlib.Path(sys.argv[1])
    views = {}
    for folder in ("widgets", "app"):
        for source in sorted((root / folder).rglob("*.cpp")):
            try:
                views |= views_of(source.read_text(encoding="utf-8"))
            except ValueError as error:
                sys.exit(f"{source}: {error}")
    pages = {file.name: file.read_text(encoding="utf-8") for file in sorted((root / "resources/manual").glob("*.md"))}
    problems = problems_of(pages, views)
    print("\n".join(problems) or f"The manual has {len(pages)} pages, for {len(views)} views and more.")
    return 1 if problems or not views else 0


if __name__ == "__main__":
    sys.exit(main())
