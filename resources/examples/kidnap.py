#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Carries a simulated robot away again and again while it plays, and prints how soon it knows where it is.

    kidnap.py game2002-1 red1 --others 1
    kidnap.py field2002 red1 --times 20 --seed 2 --solution self-localisation=kalman

The robot is put to a random place of the field with a random heading, without being lifted, so that only what it sees can tell. It is
back when its estimate is nearer than 300 mm and 15 degrees to the truth for a whole second.
`robotctl` does the simulation: it is taken from the PATH, or from the variable ROBOTCTL.
"""
import argparse
import json
import math
import os
import pathlib
import random
import subprocess
import sys
import tempfile

HALF_LENGTH, HALF_WIDTH = 1.7, 0.95  # of the part of the field of 2002 where robots are put, m
NEAR, ALIKE = 0.3, math.radians(15)
HOLD = 1.0  # s
ROBOTCTL = os.environ.get("ROBOTCTL", "robotctl")


def run(*arguments):
    done = subprocess.run([ROBOTCTL, *arguments], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"kidnap.py: robotctl {arguments[0]} failed: {done.stderr.strip()}")


def streams(robot):
    return f"{robot}/models/pose,{robot}/oracle/world"


def is_free(x, y, others):
    """The condition of a script that ball and other robots are away from a place, where the robot would be refused otherwise."""
    things = ["ball_in_field"] + [f"others[{i}].pose_in_field" for i in range(others)]
    return " && ".join(f"(oracle/world.{thing}.x - ({x:.3f})) ^ 2 + (oracle/world.{thing}.y - ({y:.3f})) ^ 2 > 0.25" for thing in things)


def write_script(path, log, options):
    places = random.Random(options.seed)
    lines = ["simulation.speed 0", f"recording.streams {streams(options.robot)}", f"recording.start-file {log}",
             f"robot.select {options.robot}", "robot.key package/oracle/world", "simulation.start", f"wait {options.first}"]
    drawn = []
    for _ in range(options.times):
        x, y = places.uniform(-HALF_LENGTH, HALF_LENGTH), places.uniform(-HALF_WIDTH, HALF_WIDTH)
        heading = places.uniform(-math.pi, math.pi)
        lines += [f"wait until {is_free(x, y, options.others)} for 60",
                  f"scene.place {options.robot} {x:.3f} {y:.3f} {heading:.3f}", f"wait {options.every}"]
        drawn.append((x, y))
    path.write_text("\n".join(lines + ["recording.stop"]) + "\n", encoding="utf-8")
    return drawn


def errors_in(text, drawn):
    """Times with the errors of position and heading, and when the robot was put to the drawn places; a referee places robots, too."""
    truth, seen, errors, jumps = None, 0, [], []
    for line in text.splitlines():
        message = json.loads(line)
        value, time = message["message"], message["log_time"]
        if message["stream"].endswith("/oracle/world"):
            before, truth = truth, value["robot_in_field"]
            place = truth["x"], truth["y"]
            far = before and math.dist((before["x"], before["y"]), place) > 0.1 + 0.5 * (time - seen)
            if far and min(math.dist(place, one) for one in drawn) < 0.05:
                jumps.append(time)
            seen = time
        elif truth:
            pose = value["robot_in_field"]
            turned = math.remainder(pose["heading"] - truth["heading"], 2 * math.pi)
            errors.append((time, math.dist((pose["x"], pose["y"]), (truth["x"], truth["y"])), abs(turned)))
    return errors, jumps


def back_after(errors, start, end):
    """Seconds until the estimate is right and stays so for a while; None if that never happens."""
    since = None
    for time, distance, angle in errors:
        # The images of the first instants were taken before.
        if not start + 0.1 < time < end:
            continue
        if distance > NEAR or angle > ALIKE:
            since = None
        elif since is None:
            since = time
        if since is not None and time - since >= HOLD:
            return since - start
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scene")
    parser.add_argument("robot")
    parser.add_argument("--others", type=int, default=0, help="how many other robots the scene has")
    parser.add_argument("--times", type=int, default=10)
    parser.add_argument("--every", type=float, default=15, help="seconds between two of them")
    parser.add_argument("--first", type=float, default=10, help="seconds before the first")
    parser.add_argument("--within", type=float, default=10, help="seconds in which it should be back")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--layout", default="soccer")
    parser.add_argument("--solution", action="append", default=[])
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        log, script, lines = folder / "kidnap.mcap", folder / "kidnap.script", folder / "kidnap.jsonl"
        drawn = write_script(script, log, options)
        chosen = [part for solution in options.solution for part in ("--solution", solution)]
        run("sim", options.scene, "--layout", options.layout, "--seed", str(options.seed), "--script", str(script), *chosen)
        run("log", "export", str(log), "--json", streams(options.robot), str(lines))
        errors, jumps = errors_in(lines.read_text(encoding="utf-8"), drawn)
    times = [back_after(errors, jump, jump + options.every) for jump in jumps]
    for jump, seconds in zip(jumps, times):
        print(f"carried away at {jump:.1f} s: " + ("not back" if seconds is None else f"back after {seconds:.1f} s"))
    good = sum(seconds is not None and seconds <= options.within for seconds in times)
    print(f"{good} of {len(times)} back within {options.within:g} s")


if __name__ == "__main__":
    main()
