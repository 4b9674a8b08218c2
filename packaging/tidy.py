#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs clang-tidy on the project's own sources, those that were changed last first, without compiling any.

It builds only what other sources are generated from: messages and what moc makes. What clang-tidy said is kept in the build folder
until the source, a header of the project that it includes, its flags or .clang-tidy change, so that a run that was ended goes on
where it was.
Usage: tidy.py BUILD_DIR [PATH...]   only sources that are, or lie below, these paths
Status: 0 without findings, 1 with some, 2 where it could not look at a source.
"""
import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import threading

ROOT = pathlib.Path(__file__).resolve().parent.parent
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)
FINDING = re.compile(r": (?:warning|error): ")
GENERATED = re.compile(r"^(\S+(?:\.pb\.h|_autogen/timestamp|_autogen|DdsPackage\.h)): (?:CUSTOM_COMMAND|phony)", re.MULTILINE)


def build_generated(build):
    """Makes the headers and sources that others include."""
    targets = subprocess.run(["ninja", "-C", build, "-t", "targets", "all"], check=True, capture_output=True, text=True).stdout
    wanted = sorted({name for name in GENERATED.findall(targets) if not name.startswith("/")})
    subprocess.run(["ninja", "-C", build, "--quiet", *wanted], check=True)


def by_age():
    """Sources and headers in the order of their last change, the newest first."""
    log = subprocess.run(["git", "log", "--format=", "--name-only"], cwd=ROOT, check=True, capture_output=True, text=True).stdout
    changed = subprocess.run(["git", "diff", "--name-only", "HEAD"], cwd=ROOT, check=True, capture_output=True, text=True).stdout
    order = {}
    for name in (changed + log).split("\n"):
        order.setdefault(name, len(order))
    return order


def own_commands(build, paths):
    """(source, command) of the sources that are ours and lie below the paths, each once."""
    commands = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        source = pathlib.Path(entry["directory"], entry["file"]).resolve()
        if source.is_relative_to(ROOT) and not source.is_relative_to(ROOT / "build") and source.suffix == ".cpp":
            commands.setdefault(source, entry["command"])
    for path in paths:
        if not any(source.is_relative_to(path) for source in commands):
            sys.exit(f"{path}: no source that is compiled lies there")
    if paths:
        commands = {source: command for source, command in commands.items() if any(source.is_relative_to(path) for path in paths)}
    order = by_age()
    return sorted(commands.items(), key=lambda item: order.get(str(item[0].relative_to(ROOT)), len(order)))


class Contents:
    """Digests of sources together with all of the project that they include."""

    def __init__(self):
        self.direct = {}
        self.lock = threading.Lock()
        protos = sorted(ROOT.glob("[!b]*/**/*.proto"))
        self.messages = hashlib.sha256(b"".join(p.read_bytes() for p in protos)).digest()

    def of_file(self, path):
        """(digest of its text, what it includes); None if it is none of ours."""
        with self.lock:
            if path not in self.direct:
                if not path.is_file():
                    self.direct[path] = None
                else:
                    text = path.read_text(errors="replace")
                    self.direct[path] = hashlib.sha256(text.encode()).digest(), INCLUDE.findall(text)
            return self.direct[path]

    def digest(self, source, command):
        whole = hashlib.sha256((ROOT / ".clang-tidy").read_bytes() + command.encode())
        seen, waiting = {source}, [source]
        while waiting:
            path = waiting.pop()
            digest, includes = self.of_file(path)
            whole.update(digest)
            for name in includes:
                if name.endswith(".pb.h"):
                    whole.update(self.messages)
                for include in (ROOT / name, path.parent / name):
                    if include not in seen and self.of_file(include):
                        seen.add(include)
                        waiting.append(include)
        return whole.hexdigest()


def look_at(source, command, build, contents):
    """(whether it was looked at now, what clang-tidy said, its status) of one source."""
    kept = build / "tidy" / (str(source.relative_to(ROOT)) + ".txt")
    digest = contents.digest(source, command)
    if kept.is_file():
        known, said = kept.read_text().split("\n", 1)
        if known == digest:
            return False, said, 0
    run = subprocess.run(["clang-tidy-14", "--quiet", "-p", str(build), "--extra-arg=-Wno-unknown-warning-option", str(source)],
                         capture_output=True, text=True)
    said = run.stdout.strip()
    if run.returncode != 0 and not FINDING.search(said):
        return True, said + run.stderr.strip(), run.returncode
    kept.parent.mkdir(parents=True, exist_ok=True)
    kept.write_text(digest + "\n" + said)
    return True, said, 0


def findings(said):
    """What clang-tidy said, cut into findings with the lines that show where."""
    found = []
    for line in said.splitlines():
        if FINDING.search(line):
            found.append(line)
        elif found:
            found[-1] += "\n" + line
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("paths", nargs="*", type=pathlib.Path)
    arguments = parser.parse_args()
    build = arguments.build.resolve()
    paths = [path.resolve() for path in arguments.paths]
    build_generated(str(build))
    commands = own_commands(build, paths)
    contents, shown = Contents(), set()
    looked_at, with_findings, failed = 0, 0, 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        results = {pool.submit(look_at, source, command, build, contents): source for source, command in commands}
        try:
            for done, result in enumerate(concurrent.futures.as_completed(results), 1):
                is_new, said, status = result.result()
                looked_at += is_new
                found = findings(said)
                with_findings += bool(found)
                for finding in found:
                    if finding not in shown:  # those in headers are found by each source that includes them
                        shown.add(finding)
                        print(finding, flush=True)
                if status != 0:
                    failed += 1
                    print(f"{results[result]}: clang-tidy ended with {status}: {said}", flush=True)
                elif is_new and sys.stderr.isatty():
                    print(f"[{done}/{len(commands)}] {results[result].relative_to(ROOT)}", file=sys.stderr)
        except KeyboardInterrupt:
            pool.shutdown(cancel_futures=True)
            sys.exit("\nThe next run goes on from here.")
    print(f"{len(commands)} sources, {looked_at} of them looked at now: {with_findings} have findings, {len(shown)} in all"
          + (f"; {failed} could not be looked at" if failed else ""))
    sys.exit(2 if failed else 1 if with_findings else 0)


if __name__ == "__main__":
    main()
