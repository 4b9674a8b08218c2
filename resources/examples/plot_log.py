#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plots values of a log file, as an example of how to get at logs from Python.

    plot_log.py game.mcap red1/models/ball.position_in_robot.x 'red1/joints/states.joints[name="headPan"].position'
    plot_log.py game.mcap red1/models/ball.position_in_robot.x --output ball.png

Values are written as in the workbench's plots: the stream, then the field; elements of lists by their number, [0], or by a field of theirs.
`robotctl` does the reading: it prints each message as a JSON object on a line. It is taken from the PATH, or from the variable ROBOTCTL.
Needs Debian's python3-matplotlib.
"""
import argparse
import json
import os
import re
import subprocess
import sys

STEP = re.compile(r'\.?(\w+)|\[(\d+)\]|\[(\w+)="([^"]*)"\]')


def split_path(path):
    """The stream and the steps to the field: "red1/models/ball.x" is ("red1/models/ball", ...)."""
    begin = path.find(".", path.split("[")[0].rfind("/") + 1)
    if begin < 0:
        sys.exit(f'plot_log.py: "{path}" has no field; write STREAM.FIELD')
    steps, at = [], begin
    while at < len(path):
        step = STEP.match(path, at)
        if not step:
            sys.exit(f'plot_log.py: "{path}" cannot be read from "{path[at:]}" on')
        steps.append(step.groups())
        at = step.end()
    return path[:begin], steps


def value_in(message, steps):
    """The number that the steps lead to; None if this message has none."""
    for name, index, key, wanted in steps:
        if name is not None:
            message = message.get(name) if isinstance(message, dict) else None
        elif not isinstance(message, list):
            message = None
        elif index is not None:
            message = message[int(index)] if int(index) < len(message) else None
        else:
            message = next((element for element in message if str(element.get(key)) == wanted), None)
        if message is None:
            return None
    return float(message) if isinstance(message, (int, float)) else None


def read(log, stream, steps):
    """Times in seconds and values."""
    command = [os.environ.get("ROBOTCTL", "robotctl"), "log", "export", log, "--json", stream, "-"]
    times, values = [], []
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as robotctl:
        for line in robotctl.stdout:
            record = json.loads(line)
            value = value_in(record["message"], steps)
            if value is not None:
                times.append(record["log_time"])
                values.append(value)
    if robotctl.returncode not in (0, 3):  # 3: parts of the log are damaged
        sys.exit(robotctl.returncode)
    return times, values


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("log", help="a log file that robotctl opens")
    parser.add_argument("path", nargs="+", help="STREAM.FIELD")
    parser.add_argument("--output", help="a picture (.png, .svg, .pdf), instead of a window")
    arguments = parser.parse_args()
    try:
        import matplotlib
    except ImportError:
        sys.exit("plot_log.py: matplotlib is missing: sudo apt install python3-matplotlib")
    if arguments.output:
        matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(10, 5), layout="constrained")
    for path in arguments.path:
        times, values = read(arguments.log, *split_path(path))
        if not times:
            sys.exit(f'plot_log.py: {arguments.log} has no numbers "{path}"; robotctl log info lists its streams')
        axes.plot(times, values, label=path)
        print(f"{path}: {len(values)} values, {min(values):g} to {max(values):g}")
    axes.set_xlabel("time of the log [s]")
    axes.grid(alpha=0.3)
    axes.legend()
    if arguments.output:
        figure.savefig(arguments.output)
    else:
        pyplot.show()


if __name__ == "__main__":
    main()
