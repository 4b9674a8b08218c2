#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails where two sources that a unity build may compile together define the same name for themselves.

Looks at anonymous namespaces and at what is static; functions may share a name if their parameters differ. Nor may a source
define a type for itself that another one's header declares for all. It reads the sources roughly, to say in a second what the
compiler says after minutes.
Usage: unity_names.py BUILD_DIR, of a unity build
"""
import collections
import pathlib
import re
import sys

LITERALS = re.compile(r'R"(\w*)\(.*?\)\1"|//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])*\'|^[ \t]*#[^\n]*',
                      re.DOTALL | re.MULTILINE)
TYPE = re.compile(r"(?:struct|class|enum class|enum|union) (\w+)[^(]*$")
ALIAS = re.compile(r"(?:using|namespace) (\w+) ?= ?(.*)")
FUNCTION = re.compile(r"(\w+) ?\((.*)\)[^()]*$")
VARIABLE = re.compile(r"(\w+)(?: ?\[[^\]]*\])* ?(?:=.*)?$")


def parameter_types(text):
    """The types of parameters as words, without names and defaults."""
    depth, parts = 0, [""]
    for letter in text:
        depth += (letter in "<([{") - (letter in ">)]}")
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    words = [re.findall(r"[\w:]+|[&*<>]", part.split("=")[0]) for part in parts if part.strip()]
    return tuple(" ".join(w[:-1] if len(w) > 1 and re.match(r"[a-z_]\w*$", w[-1]) else w) for w in words)


def without_template(head):
    """A declaration without its template parameters."""
    if not re.match(r"template ?<", head):
        return head
    depth = 0
    for place, letter in enumerate(head):
        depth += (letter == "<") - (letter == ">")
        if letter == ">" and depth == 0:
            return head[place + 1:].strip()
    return ""


def without_value(head):
    """A declaration up to the value that it gives; defaults of parameters are none."""
    for match in re.finditer(r"(?<![=!<>])=(?!=)", head):
        if head.count("(", 0, match.start()) == head.count(")", 0, match.start()):
            return head[:match.start()]
    return head


def declared(head):
    """(name, what makes it another thing) of each thing that a declaration's beginning declares."""
    if found := first_declared(head):
        yield found
        if found[1] == "variable":  # and others with values, as in "constexpr int kOne = 1, kTwo = 2"
            yield from ((name, "variable") for name in re.findall(r", (\w+)(?: ?\[[^\]]*\])* ?=(?!=)", re.sub(r"\([^()]*\)", "", head)))


def first_declared(head):
    """(name, what makes it another thing) of the first, or None."""
    head = without_template(re.sub(r"\s+", " ", head).strip())
    head = re.sub(r"\)(?: const| noexcept| override)+$", ")", head)
    if match := re.match(r", (\w+)$", head):  # the second of several variables with values in braces
        return match[1], "variable"
    if not re.match(r"[A-Za-z_\[:]", head) or head.startswith("using namespace"):
        return None
    if match := ALIAS.match(head):
        return match[1], ("alias", "::".join(match[2].split("::")[-2:]))
    if head.startswith("using"):
        return None
    if match := TYPE.match(head):
        return match[1], "type"
    before = without_value(head)
    if before.count("(") > before.count(")"):  # a parameter's default in braces ends what is known of the function
        before += ")"
    if (match := FUNCTION.search(before)) and "operator" not in before and "::" + match[1] not in before:
        return (match[1], parameter_types(match[2])) if not match[1].isupper() and match[1] not in ("TEST_F", "TEST_P") else None
    if (match := VARIABLE.search(before.strip())) and " " in before.strip():
        return match[1], "variable"
    return None


def names_of(path):
    """What a source declares for itself, or a header for all."""
    text = LITERALS.sub(lambda match: '""' if match[0][0] in "\"'R" else " ", path.read_text(errors="replace"))
    is_header, blocks, head = path.suffix == ".h", [], ""
    for letter in text:
        if letter not in "{};":
            head += letter
            continue
        outside = all(block != "other" for block in blocks)
        own = is_header or "anonymous" in blocks or re.match(r"\s*static\b", head)
        if letter != "}" and outside and own and not re.search(r"\bnamespace\b[^=]*$", head):
            if letter == "{" or not TYPE.match(head.strip()):  # "class Color;" only names another's
                yield from declared(head)
        if letter == "{":
            match = re.search(r"\bnamespace\s*([\w:]*)\s*$", head)
            blocks.append("other" if match is None else "named" if match[1] else "anonymous")
        elif letter == "}" and blocks:
            blocks.pop()
        head = ""


def targets_of(build):
    """The sources that unity builds compile together, by their targets' folders."""
    targets = collections.defaultdict(list)
    for unity in sorted(build.rglob("CMakeFiles/*.dir/Unity/unity_*.cxx")):
        included = re.findall(r'^#include "(.*)"', unity.read_text(), re.MULTILINE)
        targets[unity.parent.parent.name[:-len(".dir")]] += [pathlib.Path(name) for name in included]
    return targets


def main():
    targets = targets_of(pathlib.Path(sys.argv[1]))
    problems = []
    for target, sources in targets.items():
        found = collections.defaultdict(lambda: collections.defaultdict(set))
        shared = collections.defaultdict(set)
        for source in sources:
            if source.exists() and source.suffix == ".cpp":
                for name, kind in names_of(source):
                    found[name][kind].add(source.name)
        for header in {header for folder in {source.parent for source in sources} for header in folder.glob("*.h")}:
            for name, kind in names_of(header):
                if kind == "type" or isinstance(kind, tuple) and kind[:1] != ("alias",):
                    shared[name].add(header.name)
        for name, kinds in sorted(found.items()):
            for kind, files in kinds.items():
                if len(files) > 1 and not (isinstance(kind, tuple) and kind[:1] == ("alias",)):
                    problems.append(f"{target}: {name} stands in {' and in '.join(sorted(files))}")
            things = [kind for kind in kinds if isinstance(kind, str) or kind[:1] == ("alias",)]
            everywhere = set().union(*kinds.values())
            if things and len(kinds) > 1 and len(everywhere) > 1:
                problems.append(f"{target}: {name} means several things in {' and in '.join(sorted(everywhere))}")
            if hidden := shared[name]:
                problems.append(f"{target}: {name} of {' and '.join(sorted(everywhere))} hides that of {' and '.join(sorted(hidden))}")
    count = sum(map(len, targets.values()))
    print("\n".join(problems) or f"the names of {count} sources in {len(targets)} targets are unique")
    if problems:
        print("Give them names that say more, or put what is the same into a header: unity builds compile these together.")
    return 1 if problems or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
