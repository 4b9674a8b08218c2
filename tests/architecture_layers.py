#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails, naming file and line, where a folder includes one that the architecture does not let it use.

The tables are those of ARCHITECTURE.md. TARGETS says which targets a target may include; ROOMS lists the
folders of a target in their order: a folder may include those before it. A folder that is in neither table
fails. What widgets/CMakeLists.txt lists as widgets_models knows no Qt Widgets and no view. A
test that is named after a unit is in the folder of tests/ that mirrors the unit's room, or in one beside it, not above it.
Threads are made by the classes of robotlink/base/threads and by Worker; the other files that make one are in THREADS.
Usage: architecture_layers.py SOURCE_DIR
"""
import pathlib
import re
import sys

PROGRAM = ["robotlink/base", "robotlink/config", "robotlink/packages", "robotlink/process", "robotlink/debugging",
           "robotlink/motions"]
ROBOTLINK = PROGRAM + ["robotlink/dds", "robotlink/ros", "robotlink/decoding", "robotlink/expressions", "robotlink/series", "robotlink/calibration", "robotlink/session", "robotlink/truth", "robotlink/commands", "robotlink/foxglove", "robotlink/arcos"]
SIMULATED = ["robotlink/arcos/server", "robotlink/foxglove/session", "simcore", "colortool", "logplayer", "logplayer/mcap", "modules"] + ROBOTLINK

TARGETS = {
    "robotlink/base": [],
    "robotlink/config": ["robotlink/base"],
    "robotlink/packages": ["robotlink/base"],
    "robotlink/expressions": ["robotlink/base", "robotlink/packages"],
    "robotlink/process": ["robotlink/base", "robotlink/config", "robotlink/packages"],
    "robotlink/ros": ["robotlink/base", "robotlink/packages", "robotlink/process"],
    "robotlink/decoding": ["robotlink/base", "robotlink/config", "robotlink/packages", "robotlink/process", "robotlink/ros"],
    "robotlink/debugging": ["robotlink/base", "robotlink/config", "robotlink/packages", "robotlink/process", "robotlink/motions"],
    "robotlink/dds": ["robotlink/base", "robotlink/packages", "robotlink/process", "robotlink/debugging"],
    "robotlink/session": ["robotlink/base", "robotlink/config", "robotlink/packages", "robotlink/process",
                          "robotlink/debugging"],
    "robotlink/truth": ["robotlink/base", "robotlink/config", "robotlink/packages", "robotlink/process", "robotlink/debugging"],
    "robotlink/commands": ["robotlink/base", "robotlink/packages", "robotlink/process", "robotlink/debugging",
                           "robotlink/expressions", "robotlink/session"],
    "robotlink/motions": ["robotlink/base"],
    "robotlink/series": ["robotlink/base"],
    "robotlink/calibration": ["robotlink/base"],
    "robotlink/arcos": ["robotlink/base"],
    "robotlink/arcos/server": ["robotlink/base", "robotlink/arcos"],
    "robotlink/foxglove": ["robotlink/base"],
    "robotlink/foxglove/session": ["robotlink/base", "robotlink/packages", "robotlink/process", "robotlink/debugging",
                                   "robotlink/decoding", "robotlink/session", "robotlink/foxglove"],
    "simcore": ["robotlink/base"],
    "colortool": ["robotlink/base"],
    "logplayer/mcap": ["robotlink/base"],
    "logplayer": ["logplayer/mcap"] + ROBOTLINK,
    "modules": ["colortool"] + PROGRAM,
    "widgets": ["logplayer", "logplayer/mcap", "colortool"] + ROBOTLINK,
    "app/core": [folder for folder in SIMULATED if folder not in ("simcore", "robotlink/arcos/server")],
    "app/platforms": ["app/core"] + SIMULATED,
    "app/robotctl": ["app/core", "app/platforms"] + SIMULATED,
    "app/robotcontrol": ["app/core", "app/platforms", "widgets"] + SIMULATED,
}

# "." is the target's own folder. Targets that are not here have no sub-folders.
ROOMS = {
    "robotlink/base": ["bytes", "threads", ".", "network"],
    "robotlink/debugging": ["drawing", "requests", ".", "program"],
    "robotlink/arcos": ["codec", "stream", "sick", "."],
    "robotlink/foxglove": ["protocol", "security", "transport", "server", "client"],
    "robotlink/foxglove/session": [".", "remote"],
    "simcore": ["world", "noise", "maps", "meshes", "placement", "rendering", "physics/shapes", "physics/threads", "physics", "devices", "ranging", "control", "sdf", "sdf/moving", "."],
    "colortool": ["image", "table", "votes", "samples", "correction", "training", "scoring"],
    "logplayer/mcap": [".", "read", "write"],
    "logplayer": ["images", "json", "base", "file", "bhuman", "pictures", "record", "bookmarks", "export", "search", "scratch", ".", "edit"],
    "modules": [".", "behavior", "modeling", "modeling/ball", "modeling/localization", "modeling/players", "modeling/team", "motion", "navigation", "mapping", "perception", "perception/body", "perception/lines", "driving"],
    "widgets": ["controls", ".", "text", "steering", "drawings", "picture", "keys", "ports", "packets", "processes", "solutions", "image", "camera", "motion", "motions", "joints", "world", "field",
        "log", "streams", "timing", "errors", "color", "drive", "behavior", "game", "messages", "search", "console", "plots/items", "plots", "data", "overview", "sceneedit", "scene/render", "scene/gizmo", "scene", "objects", "timeline", "export", "color/image", "color/quality",
        "color/samples", "color/space"],
    "app/core": ["plugins", "truth", "team", "program", "own", "spread", "platform", "recordings", "deploy", "remote", "."],
    "app/platforms": [".", "real", "pioneer", "camera", "replay", "body", "simulated/scenetext", "simulated/world/control", "simulated/world", "simulated/snapshots", "simulated/game", "simulated", "simulated/adapter"],
    "app/robotctl": [".", "color", "compare", "link", "log", "run"],
    "app/robotcontrol": ["language", "actions", "commands", "presets", "remote", "docks", "bars", "."],
}

# Libraries whose headers only some targets may show or use.
OUTSIDE = {
    r"^ode/": ["simcore"],
    r"^embree3/": ["simcore"],
    r"^boost/": ["robotlink/arcos", "robotlink/arcos/server", "robotlink/foxglove"],
    r"^dds/": ["robotlink/dds"],
    r"^openssl/": ["robotlink/foxglove"],
    r"^sdf/": ["simcore"],
    r"^(Q[A-Z]\w*|Qt\w*/)": ["widgets", "app/robotcontrol"],
    r"^(lz4frame|zstd|libdeflate)": ["logplayer/mcap"],
    r"^opencv2/videoio": ["logplayer"],
    r"^opencv2/calib3d": ["robotlink/calibration"],
    r"^(muParser|re2/)": ["robotlink/expressions"],
    r"^kissfft/": ["robotlink/series"],
    r"^bzlib": ["colortool"],
    r"^(turbojpeg|png)\.h": ["logplayer"],
    r"^(qcustomplot|qtadvanceddocking)": ["widgets", "app/robotcontrol"],
}
# Files that make a thread by themselves. Each says at its thread why that is neither a Worker nor a PacedThread.
THREADS = [
    "app/core/own/OwnProgramMain.cpp", "app/core/program/Abandoned.cpp", "app/core/program/TurnCrew.h", "app/core/program/TurnCrew.cpp",
    "app/robotctl/Interrupt.cpp", "robotlink/base/Worker.h", "robotlink/base/network/HostLookup.cpp",
    "robotlink/foxglove/client/Connector.cpp", "robotlink/foxglove/server/Listener.cpp", "robotlink/foxglove/server/ListenerPort.h",
    "robotlink/process/ThreadExecutor.h", "robotlink/process/ThreadExecutor.cpp",
]
# Asking for the number of processors makes no thread.
THREAD = re.compile(r"\bstd::(j?thread\b(?!::)|async\b)|\bpthread_create\b|\bQThread\b")
QT_WIDGETS = re.compile(r"^(QtWidgets|QWidget|Q(Abstract)?(Button|ItemView|ScrollArea|Slider)|QApplication|QStyle\w*|"
                        r"QDialog|QMenu|QToolBar|QToolTip|QAction|QLayout|Q\w*(Box|Edit|Label|View|Dialog|Bar|Delegate))$")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^">]+)[>"]')


def split(path):
    """The target and the room of a file; the room is "." in the target's own folder."""
    folder = str(pathlib.PurePosixPath(path).parent)
    matches = [target for target in TARGETS if folder == target or folder.startswith(target + "/")]
    if not matches:
        return None, None
    target = max(matches, key=len)
    return target, folder[len(target) + 1:] or "."


def models_of(root):
    """The files that widgets/CMakeLists.txt lists as models, without their suffix."""
    text = (root / "widgets/CMakeLists.txt").read_text()
    listed = re.search(r"robotcontrol_library\(widgets_models MOC\s+SOURCES(.*?)PUBLIC", text, re.S)
    return {f"widgets/{name}" for name in re.findall(r"([\w/]+)\.cpp", listed.group(1))}


def room_problem(target, room, included_target, included_room):
    if included_target != target:
        if included_target not in TARGETS[target]:
            return f"{target} may not include {included_target}"
        return None
    order = ROOMS.get(target, ["."])
    if included_room in order and order.index(included_room) > order.index(room):
        return f"{target}/{room} may not include {target}/{included_room}, which comes after it"
    return None


def problems_of(source, relative, target, room, models):
    is_model = relative.rsplit(".", 1)[0] in models
    for number, line in enumerate(source.read_text(errors="replace").splitlines(), 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        kind, included = match.groups()
        included_target, included_room = split(included) if kind == '"' else (None, None)
        if included_target:
            problem = room_problem(target, room, included_target, included_room)
            if problem:
                yield f"{relative}:{number}: {problem} ({included})"
            is_view = included_target == "widgets" and (source.parents[len(relative.split("/")) - 1] /
                                                        (included[:-2] + ".cpp")).exists()
            if is_model and is_view and included[:-2] not in models:
                yield f"{relative}:{number}: a model may not include a view ({included})"
        elif kind == "<":
            if is_model and QT_WIDGETS.match(included):
                yield f"{relative}:{number}: a model may not include <{included}>"
            for pattern, users in OUTSIDE.items():
                if re.match(pattern, included) and target not in users:
                    yield f"{relative}:{number}: {target} may not use <{included}>"


def thread_problems(sources):
    """`sources`: the text by relative path."""
    for relative, text in sources.items():
        if relative in THREADS or relative.startswith("robotlink/base/threads/"):
            continue
        for number, line in enumerate(text.splitlines(), 1):
            if THREAD.search(line.split("//")[0]):
                yield f"{relative}:{number}: use robotlink::PacedThread or robotlink::Worker rather than a thread of its own"
    for relative in THREADS:
        if not THREAD.search(sources.get(relative, "")):
            yield f"{relative}:1: it makes no thread, so {pathlib.Path(__file__).name} need not list it"


def mirror(folder):
    """The folder of tests/ for a folder of the product."""
    return re.sub(r"^app/robotcontrol\b", "app/window", re.sub(r"^app/core\b", "app", folder))


def misplaced_tests(root):
    units = {}
    for top in ("app", "widgets", "robotlink", "simcore", "logplayer", "colortool", "modules"):
        for header in (root / top).rglob("*.h"):
            units.setdefault(header.stem, []).append(mirror(header.parent.relative_to(root).as_posix()))
    for test in sorted((root / "tests").rglob("*Test.cpp")):
        folder = test.parent.relative_to(root / "tests").as_posix()
        rooms = units.get(test.stem.removesuffix("Test"), [])
        if len(rooms) == 1 and rooms[0].startswith(folder + "/"):
            yield f"{test.relative_to(root).as_posix()}:1: the test of a unit in {rooms[0]} belongs to tests/{rooms[0]}"


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    models = models_of(root)
    problems, files, sources = [], 0, {}
    for top in ("app", "widgets", "robotlink", "simcore", "logplayer", "colortool", "modules"):
        for source in sorted((root / top).rglob("*")):
            if source.suffix not in (".h", ".cpp"):
                continue
            files += 1
            relative = source.relative_to(root).as_posix()
            sources[relative] = source.read_text(errors="replace")
            target, room = split(relative)
            if target is None or room not in ROOMS.get(target, ["."]):
                problems.append(f"{relative}:1: this folder is not in the tables of {pathlib.Path(__file__).name}")
            else:
                problems.extend(problems_of(source, relative, target, room, models))
    problems.extend(misplaced_tests(root))
    problems.extend(thread_problems(sources))
    print("\n".join(problems) or f"{files} files include only what they may")
    return 1 if problems or files == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
