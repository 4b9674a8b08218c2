#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the templates of programs for Pioneers on simulated robots, as a user would.

Usage: pioneer_programs.py --robotctl FILE --programs FOLDER --source FOLDER [unittest's arguments]
"""
import argparse
import math
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import simulator

OPTIONS = argparse.Namespace()
DRIVE = None


def real_map(name):
    path = os.path.join(OPTIONS.source, "../shared/data/arcos", name)
    if not os.path.exists(path):
        raise unittest.SkipTest(f"there is no {path}")
    return path


def program(name):
    return os.path.join(OPTIONS.programs, name)


def simulate(scene, robots, *options):
    return simulator.Simulator(OPTIONS.robotctl, scene, robots, *options)


def arena():
    """An empty place of 40 m by 40 m."""
    return os.path.join(OPTIONS.source, "tests/templates/arena.map")


class Programs(unittest.TestCase):
    """Each template on robots of its own, all at the same time, in an arena with room for all of them."""

    # The places of the robots of each program: x and y in m, heading in degrees.
    PLACES = {
        "sense_plan_act": [(-15, -15, 0)],
        "accelerate": [(-15, -10, 0)],
        "circles": [(-15, -5, 0)],
        "follow_path": [(-15, 0, 0)],
        "wander": [(-15, 5, 0)],
        "concurrent": [(-15, 10, 0)],
        "convoy": [(0, -10, 0), (0, -14, 0)],
        "meeting_point": [(0, 0, 0), (2.5, 0.5, 90), (1, 2.5, 200)],
        "python": [(0, 12, 0)],
        "ada": [(8, 12, 0)],
    }

    def command(self, name, urls):
        if name == "python":
            return [sys.executable, os.path.join(OPTIONS.source, "resources/templates/pioneer/python/drive.py"), *urls, "6"]
        if name == "ada":
            return [os.path.join(self.folder.name, "drive"), *urls, "6.0"]
        return [program(name), *urls, {"follow_path": "0.6", "meeting_point": "20"}.get(name, "8")]

    def build_ada(self):
        subprocess.run(["gnatmake", "-q", "-gnatwae", os.path.join(OPTIONS.source, "resources/templates/pioneer/ada/drive.adb")],
                       cwd=self.folder.name, check=True)

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.places = dict(self.PLACES)
        if shutil.which("gnatmake"):
            self.build_ada()
        else:
            print("there is no gnatmake (package gnat): the program in Ada is not tested", file=sys.stderr)
            del self.places["ada"]

    def test_every_program_drives_its_robots(self):
        robots = sum(map(len, self.places.values()))
        with simulate(arena(), robots) as simulation:
            urls, running, next_robot = {}, {}, 0
            for name, places in self.places.items():
                urls[name] = [simulation.url(next_robot + i) for i in range(len(places))]
                next_robot += len(places)
                for url, place in zip(urls[name], places):
                    simulator.put(DRIVE, url, *place)
            for name in self.places:
                running[name] = subprocess.Popen(self.command(name, urls[name]), stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                                 text=True)
            said = {}
            for name, process in running.items():
                output, errors = process.communicate(timeout=60)
                self.assertEqual(process.returncode, 0, f"{name}: {output}{errors}")
                said[name] = output
            ends = {name: [simulator.true_pose(DRIVE, url) for url in urls[name]] for name in self.places}
            figures = simulation.figures()
        self.check(said, ends)
        self.assertEqual(figures["contacts"], 0, figures)

    def way(self, name, ends, robot=0):
        return math.dist(ends[name][robot], self.places[name][robot][:2])

    def check(self, said, ends):
        self.assertGreater(self.way("sense_plan_act", ends), 1.5)
        self.assertRegex(said["sense_plan_act"], r"battery 1\d")
        self.assertRegex(said["accelerate"], r"fastest: 0\.3")
        self.assertLess(abs(self.way("accelerate", ends) - 0.05 * 8**2 / 2), 0.4)
        self.assertRegex(said["circles"], r"turned 1\d\d")
        self.assertLess(self.way("follow_path", ends), 0.25, "it does not come back")
        self.assertEqual(said["follow_path"].count("at "), 4)
        self.assertGreater(self.way("wander", ends), 1.5)
        self.assertIn("all periods were held", said["concurrent"])
        self.assertGreater(self.way("convoy", ends), 1)
        self.assertLess(abs(math.dist(*ends["convoy"]) - 1.7), 0.5, "the second one does not follow")
        self.assertIn("3 of 3 met", said["meeting_point"])
        for a, b in ((0, 1), (1, 2), (0, 2)):
            self.assertLess(abs(math.dist(ends["meeting_point"][a], ends["meeting_point"][b]) - 1.6), 0.5)
        self.assertIn("a p3at-sh", said["python"])
        self.assertGreater(self.way("python", ends), 0.8)
        if "ada" in said:
            self.assertGreater(self.way("ada", ends), 0.8)


class SameProgram(unittest.TestCase):
    """One program, two kinds of line."""

    def test_it_comes_to_the_same_place_over_tcp_and_over_a_serial_line(self):
        with simulate(arena(), 1) as simulation:
            ends = []
            for serial in (False, True):
                simulator.put(DRIVE, simulation.url(), 1, 2, 30)
                line = simulator.SerialBridge(simulation.url()) if serial else None
                done = subprocess.run([program("follow_path"), line.url if line else simulation.url(), "1.0"], text=True,
                                      capture_output=True, timeout=60)
                self.assertEqual(done.returncode, 0, done.stderr)
                if line:
                    self.assertGreater(line.carried[0], 1000)
                    self.assertGreater(line.carried[1], 5000)
                    line.close()
                ends.append(simulator.true_pose(DRIVE, simulation.url()))
        print(f"over TCP {ends[0]}, over the serial line {ends[1]}: {math.dist(*ends):.3f} m apart", file=sys.stderr)
        self.assertLess(math.dist(*ends), 0.05)


class Wander(unittest.TestCase):
    """In a map of a real building. Faster than real time: the program lives by the robot's states, not by the clock."""

    def wander(self, seconds, *options):
        with simulate(real_map("columbia.map"), 1, *options) as simulation:
            done = subprocess.run([program("wander"), simulation.url(), str(seconds)], text=True, capture_output=True)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            figures = simulation.figures()
        print(figures, file=sys.stderr)
        self.assertEqual(figures["contacts"], 0)

    def test_it_touches_nothing(self):
        self.wander(60, "--speed", "3")

    def test_it_touches_nothing_for_ten_minutes(self):
        if not OPTIONS.long:
            raise unittest.SkipTest("takes ten minutes: --long")
        self.wander(600)


def main():
    global DRIVE
    parser = argparse.ArgumentParser()
    for name in ("robotctl", "programs", "source"):
        parser.add_argument("--" + name, required=True)
    parser.add_argument("--long", action="store_true")
    rest = parser.parse_known_args(namespace=OPTIONS)[1]
    OPTIONS.source = os.path.abspath(OPTIONS.source)
    DRIVE = simulator.load_drive(OPTIONS.source)
    unittest.main(argv=[sys.argv[0], *rest], verbosity=2)


if __name__ == "__main__":
    main()
