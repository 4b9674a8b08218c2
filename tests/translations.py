#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that the workbench is translated completely: each text that lupdate finds in it is in each file
resources/translations/robotcontrol_*.ts, with a translation that has the same places (%1) and ends as the source does.

Usage: translations.py PROJECT_FOLDER            checks
       translations.py --update PROJECT_FOLDER   adds new texts to the files, unfinished, and removes those that no source has
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

FOLDERS = ("app/robotcontrol", "widgets")
FILES = "resources/translations/robotcontrol_*.ts"
# Sources without Qt cannot mark their texts; what the window translates of them is found by these rules, by context.
LITERALS = r'((?:"(?:[^"\\]|\\.)*"\s*)+)'
COMMANDS = "robotlink/commands/*Catalog.cpp"
PLATFORMS = "app/[cp]*/**/*.cpp"
# Help of the command line alone.
HEADLESS = re.compile("Headless")
FIELDS = "accept|emptyText|entry|entryHelp|fileEntry|fileFilter|files|group|help|hint|label|listAgain|title|toggle|unit"
RULES = (
    ("Command", COMMANDS, re.compile(r'\{\s*"[\w-]+\.[\w.-]+",\s*' + LITERALS)),
    ("Command", PLATFORMS, re.compile(r"\.commandHelp\s*=\s*" + LITERALS)),
    ("Platform", PLATFORMS, re.compile(rf"\.(?:{FIELDS})\s*=\s*" + LITERALS)),
    ("Platform", PLATFORMS, re.compile(r"\bformText\(" + LITERALS + r"\)")),
    ("PointFilter", "robotlink/series/PointFilter.cpp", re.compile(r'\{"([\w-]+)", (?:nullptr|"[\w ]+")(?=[,}])')),
    ("PointFilter", "robotlink/series/PointFilter.cpp", re.compile(r'\{"[\w-]+", "([\w ]+)"(?=[,}])')),
)
OPAQUE_ENUM = re.compile(r"\benum class \w+ : [\w:]+;")
# A function or a lambda of one's own that translates its argument: lupdate does not know its texts, unless they are marked.
OWN_FUNCTION = re.compile(r"(?:QString (\w+)\(const char\* ?\w+\)|\b(\w+) = \[\]\(const char\* ?\w+\)) \{\s*return "
                          r'QCoreApplication::translate\("\w[\w:]*", \w+\)')
DIGIT_SEPARATOR = re.compile(r"(?<=[0-9a-fA-F])'(?=[0-9a-fA-F])")
PLACE = re.compile(r"%L?\d+|%n")


def marked_texts(project):
    """A source that marks all texts of sources without Qt."""
    lines = set()
    for context, pattern, rule in RULES:
        for path in sorted(project.glob(pattern)):
            source = path.read_text(encoding="utf-8")
            if HEADLESS.search(path.name) or context == "Platform" and not re.search(r"\bPlatform(?:Field|Form|Registration)\b", source):
                continue
            for text in rule.findall(source):
                text = text.strip() if text.startswith('"') else f'"{text}"'
                if text != '""':
                    lines.add(f'QT_TRANSLATE_NOOP("{context}", {" ".join(text.split(chr(10)))});\n')
    return "".join(sorted(lines))


def copy_sources(project, folder):
    """Copies all that lupdate reads, without what it does not understand: 30'000, and declarations of enumerations."""
    for part in FOLDERS:
        for path in (project / part).rglob("*"):
            if path.suffix in (".cpp", ".h"):
                source = OPAQUE_ENUM.sub("", DIGIT_SEPARATOR.sub("", path.read_text(encoding="utf-8")))
                copy = folder / path.relative_to(project)
                copy.parent.mkdir(parents=True, exist_ok=True)
                copy.write_text(source, encoding="utf-8")
    (folder / FOLDERS[0] / "TextsWithoutQt.cpp").write_text(marked_texts(project), encoding="utf-8")


def lupdate(project, ts):
    """Brings a .ts file up to date; a new one has all texts. Returns what lupdate objects to."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        copy_sources(project, folder)
        copy = folder / ts.name
        if ts.exists():
            shutil.copy(ts, copy)
        run = subprocess.run(["lupdate", "-silent", "-no-obsolete", "-locations", "none", "-source-language", "en", "-target-language",
                              ts.stem.split("_")[-1], "-I", ".", *FOLDERS, "-ts", ts.name],
                             cwd=folder, text=True, capture_output=True, check=False)
        if run.returncode != 0:
            sys.exit("lupdate (Debian's package qttools5-dev-tools) failed:\n" + run.stderr)
        shutil.copy(copy, ts)
        return [line.replace(f"{folder}/", "") for line in run.stderr.splitlines() if line.strip()]


def unknown_texts(source):
    """Calls of own functions that translate texts which lupdate does not find."""
    for function in OWN_FUNCTION.finditer(source):
        name = function.group(1) or function.group(2)
        yield from re.findall(rf'(?<![\w.:]){name}\("[^"]*"', source)


def problems_of_sources(project):
    """Texts that lupdate does not find, a line each."""
    for part in FOLDERS:
        for path in sorted((project / part).rglob("*.cpp")):
            for call in unknown_texts(path.read_text(encoding="utf-8")):
                yield (f"{path.relative_to(project)}: {call}) is not found by lupdate; call the tr() of a struct with "
                       "Q_DECLARE_TR_FUNCTIONS instead")


def messages_of(ts):
    """(context, source, comment) to (translation, whether it is finished) of all texts of a .ts file."""
    messages = {}
    for context in ElementTree.parse(ts).getroot().iter("context"):
        for message in context.iter("message"):
            translation = message.find("translation")
            key = (context.findtext("name"), message.findtext("source"), message.findtext("comment") or "")
            messages[key] = (translation.text or "", translation.get("type") is None)
    return messages


def end_of(text):
    """How a text ends, as far as translations have to end so, too."""
    return re.search(r"(…|\.\.\.|:)?\s*$", text).group(1)


def fault_of(source, translation, finished):
    """What is wrong with a translation; empty if nothing is."""
    if not translation.strip() and source.strip():
        return "is not translated"
    if not finished:
        return "is marked as unfinished"
    if sorted(PLACE.findall(source)) != sorted(PLACE.findall(translation)):
        return f'has other places (%1) than its translation "{translation}"'
    if end_of(source) != end_of(translation):
        return f'ends otherwise than its translation "{translation}"'
    if source.count("&&") != translation.count("&&"):
        return f'has an & that its translation "{translation}" does not double'
    return ""


def problems_of(wanted, translated):
    """What is wrong with a file, a line each: `wanted` and `translated` are texts as messages_of() returns them."""
    for key in wanted:
        context, source, _ = key
        fault = fault_of(source, *translated[key]) if key in translated else "is missing"
        if fault:
            yield f'{context}: "{source}" {fault}'
    for context, source, _ in translated.keys() - wanted.keys():
        yield f'{context}: "{source}" is in no source any more'


def check_itself():
    """Raises AssertionError if one of the checks would find nothing."""
    key = ("View", "%1 of %2:", "")
    assert list(problems_of({key: ("", False)}, {key: ("%1 von %2:", True)})) == []
    for translations in ({}, {key: ("", True)}, {key: ("%1 von %2:", False)}, {key: ("%1 von:", True)}, {key: ("%1 von %2", True)},
                         {key: ("%1 von %2:", True), ("View", "Old", ""): ("Alt", True)}):
        assert len(list(problems_of({key: ("", False)}, translations))) == 1, translations
    own = 'QString mine(const char* text) {\n  return QCoreApplication::translate("Mine", text);\n}\n'
    assert list(unknown_texts(own + 'mine("a"); mine(QT_TRANSLATE_NOOP("Mine", "b"));')) == ['mine("a"']
    assert DIGIT_SEPARATOR.sub("", "30'000, 'a', u'b'") == "30000, 'a', u'b'"


def main():
    check_itself()
    updates = "--update" in sys.argv
    project = pathlib.Path(sys.argv[-1]).resolve()
    files = sorted(project.glob(FILES))
    if not files:
        sys.exit(f"there is no {FILES}")
    if updates:
        for ts in files:
            print("\n".join(lupdate(project, ts) + [f"{ts.name}: up to date; translate what is unfinished in it"]))
        return 0
    with tempfile.TemporaryDirectory() as name:
        fresh = pathlib.Path(name) / "robotcontrol_en.ts"
        problems = [f"lupdate: {line}" for line in lupdate(project, fresh)]
        wanted = messages_of(fresh)
    problems += problems_of_sources(project)
    for ts in files:
        problems += [f"{ts.name}: {problem}" for problem in problems_of(wanted, messages_of(ts))]
    if problems:
        print("\n".join(problems))
        print("Run `python3 tests/translations.py --update .`, then translate what is unfinished in the .ts files, in Qt Linguist "
              "or in an editor; remove type=\"unfinished\" from what is done.")
    else:
        print(f"{len(wanted)} texts are translated in {', '.join(ts.name for ts in files)}")
    return 1 if problems or len(wanted) < 1000 else 0


if __name__ == "__main__":
    sys.exit(main())
