#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the templates of programs for Pioneers on simulated robots, as a user would.

Usage: pioneer_programs.py --robotctl FILE --programs FOLDER --source FOLDER [unittest's arguments]
"""
import argparse
import math
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # the source folder stays as it is
import simulator  # noqa: E402

OPTIONS = argparse.Namespace()
HANGS = 900  # s of real time; a busy machine is slow, but it comes to an end
DRIVE = None


def real_map(name):
    path = os.path.join(OPTIONS.source, "../shared/data/arcos", name)
    if not os.path.exists(path):
        raise unittest.SkipTest(f"there is no {path}")
    return path


def program(name):
    return os.path.join(OPTIONS.programs, name)


def simulate(scene, robots, *options, kind="p3at"):
    return simulator.Simulator(OPTIONS.robotctl, scene, robots, *options, kind=kind)


def arena():
    """An empty place of 40 m by 40 m."""
    return os.path.join(OPTIONS.source, "tests/templates/arena.map")


def distance(a, b):
    return math.dist(a[:2], b[:2])


class ProgramsTestCase(unittest.TestCase):
    def assert_turned_before_the_wall(self, name, start, end):
        self.assertGreater(distance(start, end), 0.2, f"{name} did not drive")
        self.assertGreater(abs((end[2] - start[2] + 180) % 360 - 180), 20, f"{name} did not turn: {end}")


class Programs(ProgramsTestCase):
    """Each template on robots of its own, all at the same time, in an arena with room for all of them."""

    # The places of the robots of each program: x and y in m, heading in degrees.
    PLACES = {
        "sense_plan_act": [(-18.2, -15, 180)],  # before a wall
        "accelerate": [(-15, -10, 0)],
        "circles": [(-15, -5, 0)],
        "follow_path": [(-15, 0, 0)],
        "wander": [(-15, 5, 0)],
        "concurrent": [(-15, 10, 0)],
        "convoy": [(0, -10, 0), (0, -14, 0)],
        "meeting_point": [(0, 0, 0), (2.5, 0.5, 90), (1, 2.5, 200)],
        "python": [(18, 12, 0)],  # before a wall
    }

    def command(self, name, urls):
        if name == "python":
            return [sys.executable, os.path.join(OPTIONS.source, "resources/templates/pioneer/python/drive.py"), *urls, "8"]
        return [program(name), *urls, {"follow_path": "0.6", "meeting_point": "20"}.get(name, "8")]

    def test_every_program_drives_its_robots(self):
        robots = sum(map(len, self.PLACES.values()))
        with simulate(arena(), robots) as simulation:
            urls, running, next_robot = {}, {}, 0
            for name, places in self.PLACES.items():
                urls[name] = [simulation.url(next_robot + i) for i in range(len(places))]
                next_robot += len(places)
                for url, place in zip(urls[name], places):
                    simulator.put(DRIVE, url, *place)
            for name in self.PLACES:
                running[name] = subprocess.Popen(self.command(name, urls[name]), stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                                 text=True)
            said = {}
            for name, process in running.items():
                output, errors = process.communicate(timeout=HANGS)
                self.assertEqual(process.returncode, 0, f"{name}: {output}{errors}")
                said[name] = output
            ends = {name: [simulator.true_pose(DRIVE, url) for url in urls[name]] for name in self.PLACES}
            figures = simulation.figures()
        self.check(said, ends)
        self.assertEqual(figures["contacts"], 0, figures)

    def way(self, name, ends, robot=0):
        return distance(ends[name][robot], self.PLACES[name][robot])

    def check(self, said, ends):
        self.assert_turned_before_the_wall("sense_plan_act", self.PLACES["sense_plan_act"][0], ends["sense_plan_act"][0])
        self.assertRegex(said["sense_plan_act"], r"battery 1\d")
        self.assertRegex(said["accelerate"], r"fastest: 0\.3")
        self.assertLess(abs(self.way("accelerate", ends) - 0.05 * 8**2 / 2), 0.4)
        self.assertRegex(said["circles"], r"turned 1\d\d")
        self.assertLess(self.way("follow_path", ends), 0.25, "it does not come back")
        self.assertEqual(said["follow_path"].count("at "), 4)
        self.assertGreater(self.way("wander", ends), 1.5)
        self.assertIn("all periods were met", said["concurrent"])
        self.assertGreater(self.way("convoy", ends), 1)
        self.assertLess(abs(distance(*ends["convoy"]) - 1.7), 0.5, "the second one does not follow")
        self.assertIn("3 of 3 met", said["meeting_point"])
        for a, b in ((0, 1), (1, 2), (0, 2)):
            self.assertLess(abs(distance(ends["meeting_point"][a], ends["meeting_point"][b]) - 1.6), 0.5)
        self.assertIn("a p3at-sh", said["python"])
        self.assert_turned_before_the_wall("python", self.PLACES["python"][0], ends["python"][0])


class Navigation(unittest.TestCase):
    """Navigation, planning and mapping in a house; faster than real time, as the programs live by the robot's states."""

    HOME = (1.0, 5.5, 0)

    def house(self):
        return os.path.join(OPTIONS.source, "resources/scenes/house.map")

    def run_program(self, simulation, name, *arguments):
        done = subprocess.run([program(name), simulation.url(), *arguments], text=True, capture_output=True, timeout=HANGS)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def walls(self):
        with open(self.house(), encoding="utf-8") as file:
            lines = file.read().split("LINES\n")[1].split("DATA")[0].splitlines()
        return [[float(number) / 1000 for number in line.split()] for line in lines if line.strip()]

    def to_wall(self, walls, x, y):
        def to_line(x1, y1, x2, y2):
            length = (x2 - x1) ** 2 + (y2 - y1) ** 2
            share = max(0, min(1, ((x - x1) * (x2 - x1) + (y - y1) * (y2 - y1)) / length)) if length else 0
            return math.hypot(x1 + share * (x2 - x1) - x, y1 + share * (y2 - y1) - y)
        return min(to_line(*wall) for wall in walls)

    def test_a_place_is_reached_around_what_is_in_the_way(self):
        with simulate(self.house(), 1, "--speed", "3") as simulation:
            simulator.put(DRIVE, simulation.url(), 6.2, 5.5, 0)
            self.assertIn("arrived", self.run_program(simulation, "navigation", "1.6", "-2.8"))  # through a door
            end = simulator.true_pose(DRIVE, simulation.url())
            self.assertLess(distance(end, (7.8, 2.7)), 0.5)
            self.assertEqual(simulation.figures()["contacts"], 0)

    def test_a_planned_way_leads_to_a_place_of_the_map(self):
        with simulate(self.house(), 1, "--speed", "3") as simulation:
            simulator.put(DRIVE, simulation.url(), *self.HOME)
            self.assertRegex(self.run_program(simulation, "planning", self.house(), "Kitchen"), r"the way has \d\d points\narrived")
            end = simulator.true_pose(DRIVE, simulation.url())
            self.assertLess(distance(end, (7.7, 3.2)), 0.5)
            self.assertEqual(simulation.figures()["contacts"], 0)
            done = subprocess.run([program("planning"), simulation.url(), self.house(), "Nowhere"], text=True, capture_output=True, timeout=HANGS)
            self.assertEqual((done.returncode, done.stderr), (1, "the map has no Nowhere\n"))

    def test_a_map_is_made_and_read_again(self):
        with simulate(self.house(), 1, "--speed", "3") as simulation, tempfile.TemporaryDirectory() as folder:
            simulator.put(DRIVE, simulation.url(), *self.HOME)
            made = os.path.join(folder, "made.map")
            self.run_program(simulation, "mapping", "40", made)
            with open(made, encoding="ascii") as file:
                points = [[float(number) / 1000 for number in line.split()] for line in file.read().split("DATA\n")[1].splitlines()]
            walls = self.walls()
            right = sum(self.to_wall(walls, x + self.HOME[0], y + self.HOME[1]) < 0.3 for x, y in points)
            self.assertGreater(len(points), 100)
            self.assertGreater(right / len(points), 0.8, f"{right} of {len(points)}")
            self.assertEqual(simulation.figures()["contacts"], 0)


class OtherKinds(unittest.TestCase):
    """Pioneers that are there by their data alone."""

    def test_they_drive_straight_turn_and_say_what_they_are(self):
        for kind, sonars in (("p3dx", 16), ("peoplebot", 24)):
            with self.subTest(kind), simulate(arena(), 1, kind=kind) as simulation:
                simulator.put(DRIVE, simulation.url(), 0, 0, 0)
                robot = DRIVE.Pioneer(simulation.url())
                self.assertEqual(robot.subclass, kind + "-sh")
                robot.send(4, 1)  # ENABLE
                robot.send(28, 1)  # SONAR
                for _ in range(30):
                    robot.read()
                    robot.send(11, 300)  # VEL
                x, y, heading = robot.x, robot.y, robot.heading
                for _ in range(30):
                    robot.read()
                    robot.send(11, 0)
                    robot.send(21, 40)  # RVEL
                turned = (robot.heading - heading) % 360
                heard = len(robot.sonars)
                robot.close()
                end = simulator.true_pose(DRIVE, simulation.url())
                self.assertGreater(x, 0.5, "it did not drive")
                self.assertLess(abs(y), 0.1, "it did not drive straight on")
                self.assertGreater(turned, 60)
                self.assertEqual(heard, sonars)
                self.assertLess(abs(end[0] - robot.x), 0.15, "its odometry errs")
                self.assertLess(abs((end[2] - robot.heading + 180) % 360 - 180), 15, "its track is wrong")
                self.assertEqual(simulation.figures()["contacts"], 0)


class Obstacle(unittest.TestCase):
    """A program whose way is blocked says so and ends."""

    def test_a_path_that_leads_into_a_wall_ends_with_a_message(self):
        with simulate(arena(), 1) as simulation:
            simulator.put(DRIVE, simulation.url(), 18.9, 5, 0)  # the wall is 20 m from the origin
            done = subprocess.run([program("follow_path"), simulation.url(), "1.5"], text=True, capture_output=True, timeout=60)
            self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
            self.assertRegex(done.stderr, r"^stuck at \S+ m, \S+ m")
            end = simulator.true_pose(DRIVE, simulation.url())
            self.assertGreater(end[0], 19.2, "it did not drive up to the wall")
            robot = DRIVE.Pioneer(simulation.url())
            robot.read()
            self.assertEqual(robot.speed, 0, "it still pushes")
            robot.close()


class RawClient(unittest.TestCase):
    """What a client reads that speaks the protocol byte by byte, as programs do that do not use our library."""

    GRIPREQUEST, GRIPPER_PACKET = 37, 0xE0
    ORIGIN = (39.960, -75.190, 12.0)  # latitude and longitude in degrees, altitude in m

    def georeferenced(self, folder):
        """The arena, but on Earth."""
        path = os.path.join(folder, "arena.map")
        with open(arena(), encoding="ascii") as plain, open(path, "w", encoding="ascii") as placed:
            placed.write(plain.read().replace("LINES\n", "OriginLatLongAlt: %g %g %g\nLINES\n" % self.ORIGIN, 1))
        return path

    def wait_for(self, robot, identifier):
        for _ in range(200):
            body = robot.receive()
            if body[0] == identifier:
                return body
            robot.send(DRIVE.PULSE)
        self.fail(f"no packet {identifier:#x} came")

    def status(self, robot):
        robot.send(simulator.SIM_STAT, 1)
        body = self.wait_for(robot, simulator.STATUS)
        self.assertEqual(len(body), 57)
        names = ("flags", "simulated", "real", "last", "x", "y", "z", "heading", "latitude", "longitude", "altitude", "quality")
        return dict(zip(names, struct.unpack_from("<I3H8i", body, 3)))

    def test_on_a_georeferenced_map_it_has_a_place_on_earth(self):
        with tempfile.TemporaryDirectory() as folder, simulate(self.georeferenced(folder), 1) as simulation:
            simulator.put(DRIVE, simulation.url(), 10, -7, 0)
            robot = DRIVE.Pioneer(simulation.url())
            status = self.status(robot)
            robot.close()
        self.assertEqual(status["flags"] & 2, 2, "georeferenced")
        self.assertEqual((status["x"] // 100, status["y"] // 100), (100, -70))
        north = -7 / 111_035  # degrees
        east = 10 / (111_320 * math.cos(math.radians(self.ORIGIN[0])))
        self.assertAlmostEqual(status["latitude"] / 1e7, self.ORIGIN[0] + north, delta=3e-6)
        self.assertAlmostEqual(status["longitude"] / 1e7, self.ORIGIN[1] + east, delta=3e-6)
        self.assertAlmostEqual(status["altitude"] / 100, self.ORIGIN[2], delta=1)
        self.assertGreater(status["quality"], 0)

    def test_flags_say_what_is_so(self):
        with simulate(arena(), 1, "--no-noise") as simulation:
            robot = DRIVE.Pioneer(simulation.url())
            self.assertEqual(self.status(robot)["flags"] & 6, 0, "neither on Earth nor with errors of odometry")
            robot.close()
        with simulate(arena(), 1) as simulation:
            robot = DRIVE.Pioneer(simulation.url())
            self.assertEqual(self.status(robot)["flags"] & 6, 4, "its odometry errs")
            robot.close()

    def scan(self, robot):
        """How many readings a scan has."""
        body = self.wait_for(robot, 0x60)
        return struct.unpack_from("<H", body, 7)[0]

    def test_asking_for_the_gripper_does_not_move_the_laser(self):
        with simulate(arena(), 1) as simulation:
            robot = DRIVE.Pioneer(simulation.url())
            for command, argument in ((36, -90), (37, 90), (38, 100), (35, 1)):  # as ARIA's simulated laser does
                robot.send(command, argument)
            self.assertEqual(self.scan(robot), 181)
            robot.send(self.GRIPREQUEST, 1)
            answer = self.wait_for(robot, self.GRIPPER_PACKET)
            self.assertEqual(answer[1], 0, "it has no gripper")
            for _ in range(8):
                self.assertEqual(self.scan(robot), 181)
            robot.close()

    def outputs(self, robot):
        """Digital inputs and outputs, of the standard information packet."""
        body = robot.receive()
        while body[0] not in (0x32, 0x33):
            body = robot.receive()
        robot.send(DRIVE.PULSE)
        after = 20 + 3 * body[19]
        return body[after + 3], body[after + 4]

    def test_digital_outputs_are_set_by_their_mask(self):
        with simulate(arena(), 1) as simulation:
            robot = DRIVE.Pioneer(simulation.url())
            before = self.outputs(robot)[1]
            robot.send(30, 0x0F05)  # DIGOUT: the lower four
            wanted = before & 0xF0 | 0x05
            for _ in range(10):
                now = self.outputs(robot)
                if now[1] == wanted:
                    break
            self.assertEqual(now[1], wanted)
            robot.close()

    def test_moves_and_turns_end(self):
        with simulate(arena(), 1, "--no-noise") as simulation:
            robot = DRIVE.Pioneer(simulation.url())
            robot.read()
            robot.send(DRIVE.ENABLE, 1)
            x, heading = robot.x, robot.heading
            for command, argument in ((8, 400), (13, 60)):  # MOVE, DHEAD
                robot.send(command, argument)
                for _ in range(15):  # it has begun
                    robot.read()
                still = 0
                for _ in range(150):
                    before = robot.x, robot.heading
                    robot.read()
                    still = still + 1 if (robot.x, robot.heading) == before else 0
                    if still == 5:
                        break
                self.assertEqual(still, 5, "it does not end")
            self.assertAlmostEqual(math.dist((x, 0), (robot.x, 0)), 0.4, delta=0.05)
            self.assertAlmostEqual((robot.heading - heading) % 360, 60, delta=6)
            robot.close()


class Ada(ProgramsTestCase):
    """The program in Ada and its package I_Robot, where there is a compiler."""

    @classmethod
    def setUpClass(cls):
        if not shutil.which("gnatmake"):
            raise unittest.SkipTest("there is no gnatmake: install the package gnat to test the program in Ada")
        cls.folder = tempfile.TemporaryDirectory()
        source = os.path.join(OPTIONS.source, "resources/templates/pioneer/ada")
        subprocess.run(["gnatmake", "-q", "-gnatwae", f"-I{source}", os.path.join(source, "drive.adb")], cwd=cls.folder.name, check=True)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def drive(self, url, seconds="8.0"):
        return subprocess.run([os.path.join(self.folder.name, "drive"), url, seconds], text=True, capture_output=True, timeout=HANGS)

    def assert_drives(self, simulation, line=None):
        start = (18, -12, 0)
        simulator.put(DRIVE, simulation.url(), *start)
        line = line() if line else None  # it is the robot's client, too
        done = self.drive(line.url if line else simulation.url())
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r"connected with a p3at-sh\nat -?\s*\d+ mm, .* after (7|8)\d states")
        if line:
            self.assertGreater(line.carried[1], 3000)
            line.close()
        self.assert_turned_before_the_wall("Ada", start, simulator.true_pose(DRIVE, simulation.url()))
        self.assertEqual(simulation.figures()["contacts"], 0)

    def test_it_drives_its_robot_over_a_socket(self):
        with simulate(arena(), 1) as simulation:
            self.assert_drives(simulation)

    def test_it_drives_its_robot_over_a_serial_line(self):
        with simulate(arena(), 1) as simulation:
            self.assert_drives(simulation, lambda: simulator.SerialBridge(simulation.url(), 38400))

    def test_what_is_wrong_is_said(self):
        for url, problem in (("tcp://localhost:1", "no connection to localhost"), ("serial:///dev/none", "/dev/none cannot be opened"),
                             ("tcp://localhost:x", "'x' is not the port"), ("serial:///dev/none?baud=1", "9600, 19200, 38400")):
            done = self.drive(url)
            self.assertEqual(done.returncode, 1, url)
            self.assertIn(problem, done.stderr)


class SameProgram(unittest.TestCase):
    """One program, two kinds of line."""

    def test_it_comes_to_the_same_place_over_tcp_and_over_a_serial_line(self):
        with simulate(arena(), 1) as simulation:
            ends = []
            for serial in (False, True):
                simulator.put(DRIVE, simulation.url(), 1, 2, 30)
                line = simulator.SerialBridge(simulation.url()) if serial else None
                done = subprocess.run([program("follow_path"), line.url if line else simulation.url(), "1.0"], text=True,
                                      capture_output=True, timeout=HANGS)
                self.assertEqual(done.returncode, 0, done.stderr)
                if line:
                    self.assertGreater(line.carried[0], 1000)
                    self.assertGreater(line.carried[1], 5000)
                    line.close()
                ends.append(simulator.true_pose(DRIVE, simulation.url()))
        print(f"over TCP {ends[0]}, over the serial line {ends[1]}: {distance(*ends):.3f} m apart", file=sys.stderr)
        self.assertLess(distance(*ends), 0.05)


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
