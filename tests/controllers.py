#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs an example of a controller that is a program of its own with a simulation, and checks that it steers a robot.

Usage: controllers.py ROBOTCTL EXAMPLES_FOLDER SCENE CONTROLLER...
{port} and {url} in the controller's arguments are where the simulation is. It has to attach itself as "wander", and to show "nearest". With
--start it also has to start the simulation, which waits for it.
"""
import importlib.util
import pathlib
import re
import signal
import subprocess
import sys
import time

LIMIT = 60  # s
WANTED = 5  # different readings


def load_example(folder):
    specification = importlib.util.spec_from_file_location("wander", pathlib.Path(folder) / "wander.py")
    module = importlib.util.module_from_spec(specification)
    sys.dont_write_bytecode = True
    specification.loader.exec_module(module)
    return module


def port_of(simulation):
    for line in simulation.stdout:
        found = re.search(r"ws://127\.0\.0\.1:(\d+)", line)
        if found:
            return int(found.group(1))
    sys.exit("the simulation does not say where it is")


def watch(example, port):
    """The readings of wander/nearest, until there are enough different ones."""
    link, asked, seen, end = example.Link("127.0.0.1", port), False, set(), time.monotonic() + LIMIT
    topics = {}
    while len(seen) < WANTED and time.monotonic() < end:
        kind, payload = link.receive()
        if kind == 1:
            message = example.json.loads(payload)
            for topic in link.notice(message):
                if topic in ("ports", "controllers"):
                    topics[len(topics) + 1] = topic
                    link.tell(op="subscribe", subscriptions=[{"id": len(topics), "channelId": link.channels[topic]}])
        elif payload[0] == example.MESSAGE:
            topic = topics.get(int.from_bytes(payload[1:5], "little"))
            if topic == "controllers" and b"wander" in payload and not asked:
                asked = True
                link.call("read_ports", ports=["wander/nearest"])
            if topic == "ports":
                for number, value in example.fields(payload[13:]):
                    reading = dict(example.fields(value)) if number == 2 else {}
                    if reading.get(1) == b"wander/nearest" and any(reading[2]):
                        seen.add(reading[2])
    return seen


def main():
    robotctl, folder, scene, *controller = sys.argv[1:]
    example = load_example(folder)
    paused = ["--paused"] if "--start" in controller else []
    simulation = subprocess.Popen([robotctl, "sim", scene, "--listen", "127.0.0.1:0", *paused], stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True)
    started = None
    try:
        port = port_of(simulation)
        words = [word.format(port=port, url=f"ws://127.0.0.1:{port}") for word in controller]
        started = subprocess.Popen(words)
        seen = watch(example, port)
        if len(seen) < WANTED:
            sys.exit(f"only {len(seen)} different readings in {LIMIT} s: the robot does not move")
    finally:
        if started:
            started.kill()
            started.wait()
        simulation.send_signal(signal.SIGINT)
        simulation.wait(LIMIT)
    print(f"{len(seen)} different readings: the controller steers the robot")


if __name__ == "__main__":
    main()
