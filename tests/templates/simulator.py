# SPDX-License-Identifier: GPL-3.0-or-later
"""Simulated Pioneers for tests of programs: robotctl in a process of its own, and a hand that puts robots somewhere."""
import contextlib
import json
import os
import random
import signal
import socket
import struct
import subprocess
import sys
import threading
import time
import tty


def load_drive(source):
    """The worked example in Python, whose packets and connection serve here, too."""
    sys.path.insert(0, os.path.join(source, "resources/templates/pioneer/python"))
    import drive

    return drive


def free_ports(count):
    """The first of so many ports that nobody listens at."""
    while True:
        first = random.randrange(20000, 60000)
        with contextlib.ExitStack() as stack:
            try:
                for port in range(first, first + count):
                    stack.enter_context(socket.socket()).bind(("127.0.0.1", port))
                return first
            except OSError:
                continue


class Simulator:
    """`robotctl sim --arcos` in a scene or a map."""

    def __init__(self, robotctl, scene, robots, *options, kind="p3at"):
        self.port = free_ports(robots)
        self.process = subprocess.Popen(
            [robotctl, "sim", scene, "--robot", kind, "--robots", str(robots), "--arcos", str(self.port), "--json", *options],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        deadline = time.monotonic() + 120
        while True:
            try:
                socket.create_connection(("127.0.0.1", self.port), timeout=1).close()
                return
            except OSError:
                if self.process.poll() is not None or time.monotonic() > deadline:
                    self.process.kill()
                    raise RuntimeError("robotctl did not open its ports:\n" + self.process.communicate()[1]) from None
                time.sleep(0.02)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
            self.process.communicate()

    def url(self, robot=0):
        return f"tcp://127.0.0.1:{self.port + robot}"

    def figures(self):
        """Ends the simulation, and returns what it counted."""
        self.process.send_signal(signal.SIGINT)
        output, errors = self.process.communicate(timeout=120)
        try:
            return json.loads(output)
        except ValueError:
            raise RuntimeError(f"robotctl printed no figures: {output}\n{errors}") from None


SIM_SET_POSE, SIM_STAT, STATUS = 224, 237, 0x62


def put(drive, url, x, y, heading_deg):
    """Carries a robot to a place."""
    robot = drive.Pioneer(url)
    body = struct.pack("<BB3i", SIM_SET_POSE, 0, round(x * 1000), round(y * 1000), round(heading_deg))
    robot.line.sendall(b"\xfa\xfb" + bytes([len(body) + 2]) + body + struct.pack(">H", drive.checksum(body)))
    for _ in range(3):
        robot.read()
    robot.close()


def true_pose(drive, url):
    """x and y in m, heading in degrees."""
    robot = drive.Pioneer(url)
    robot.send(SIM_STAT, 1)
    body = robot.receive()
    while body[0] != STATUS:
        body = robot.receive()
    robot.close()
    x, y, _, heading = struct.unpack_from("<4i", body, 13)
    return x / 1000, y / 1000, heading


class SerialBridge:
    """A serial line to a simulated robot: a pseudo-terminal whose far end is the robot's TCP port, at the pace of `baud`."""

    def __init__(self, url, baud=9600):
        address = url.removeprefix("tcp://").split(":")
        self.tcp = socket.create_connection((address[0], int(address[1])), timeout=5)
        self.tcp.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.master, self.slave = os.openpty()
        tty.setraw(self.slave)
        self.url = f"serial://{os.ttyname(self.slave)}?baud={baud}"
        self.bytes_per_second = baud / 10
        self.carried = [0, 0]  # to the robot, from it
        for direction, (take, give) in enumerate([(lambda: os.read(self.master, 64), self.tcp.sendall),
                                                  (lambda: self.tcp.recv(8), lambda data: os.write(self.master, data))]):
            threading.Thread(target=self.carry, args=(direction, take, give), daemon=True).start()

    def carry(self, direction, take, give):
        free = time.monotonic()  # when the line has carried what it was given
        with contextlib.suppress(OSError):
            while data := take():
                free = max(free, time.monotonic()) + len(data) / self.bytes_per_second
                time.sleep(max(0.0, free - time.monotonic()))
                give(data)
                self.carried[direction] += len(data)

    def close(self):
        with contextlib.suppress(OSError):
            self.tcp.shutdown(socket.SHUT_RDWR)
        self.tcp.close()
        os.close(self.slave)
        os.close(self.master)
