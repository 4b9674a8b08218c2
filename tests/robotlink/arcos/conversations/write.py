#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the conversations of this folder: what a client says, and what a robot of ideal wheels answers.

It knows of the protocol only what its manual says, and shares no code with the library that the conversations test.
Usage: write.py
"""
import math
import pathlib
import struct

FOLDER = pathlib.Path(__file__).parent
SYNC0, SYNC1, SYNC2, OPEN, CLOSE, PULSE = 0, 1, 2, 1, 2, 0
ENABLE, SETV, MOVE, VEL, HEAD, CONFIG, SONAR, STOP = 4, 6, 8, 11, 12, 18, 28, 29
LASER_ON, LASER_START, LASER_END, LASER_STEP = 35, 36, 37, 38
NAME = b"Handmade\0Pioneer\0p3at-sh\0"
CONFIGURATION = [
    b"Pioneer\0p3at-sh\0HAND\0", ("B", 1), ("H", 360), ("H", 1500), ("H", 300), ("H", 2000), ("H", 500), b"Handmade\0",
    ("B", 100), ("B", 0), ("B", 0), ("H", 0), ("H", 1), ("B", 1), ("H", 115), ("H", 22450), ("H", 2000), ("B", 0), ("H", 200),
    ("H", 200), ("H", 700), ("H", 100), ("H", 100), ("H", 700), ("H", 100), ("H", 100), ("H", 40), ("H", 20), ("H", 0),
    ("H", 300), ("H", 300), ("H", 40), ("H", 30), ("H", 0), ("B", 5), ("B", 5), ("B", 0), ("B", 40), ("B", 0), ("B", 0),
    ("H", 0), ("B", 0), ("B", 0), ("H", 138), ("H", 110), b"2.1\0", ("H", 0), ("H", 0), ("B", 0), ("H", 0), ("H", 0), ("H", 0),
    ("H", 0), ("H", 0), ("H", 0)]


def frame(identity, data=b""):
    body = bytes([identity]) + data
    checksum = 0
    for i in range(0, len(body) - 1, 2):
        checksum = (checksum + (body[i] << 8) + body[i + 1]) & 0xFFFF
    if len(body) % 2 == 1:
        checksum ^= body[-1]
    return b"\xFA\xFB" + bytes([len(body) + 2]) + body + struct.pack(">H", checksum)


def command(identity, argument=None):
    if argument is None:
        return frame(identity)
    return frame(identity, struct.pack("<BH", 0x3B if argument >= 0 else 0x1B, abs(argument)))


def configuration():
    return b"".join(field if isinstance(field, bytes) else struct.pack("<" + field[0], field[1]) for field in CONFIGURATION)


class Robot:
    """Obeys at once but for its acceleration; in mm, degrees and seconds."""

    def __init__(self):
        self.x = self.y = self.heading = self.speed = 0.0
        self.wanted_speed, self.wanted_heading, self.left = 0.0, 0.0, None
        self.limit, self.motors, self.sonars, self.laser, self.opened = 700.0, False, True, False, None

    def obey(self, identity, argument):
        if identity == ENABLE:
            self.motors = bool(argument)
        elif identity == SETV:
            self.limit = argument
        elif identity == MOVE:
            self.left = argument
        elif identity == VEL:
            self.wanted_speed, self.left = argument, None
        elif identity == STOP:
            self.wanted_speed, self.left = 0, None
        elif identity == HEAD:
            self.wanted_heading = argument
        elif identity == SONAR:
            self.sonars = bool(argument)
        elif identity == LASER_ON:
            self.laser = bool(argument)

    def step(self, dt):
        wanted = self.wanted_speed
        if self.left is not None:
            wanted = min(self.limit, math.sqrt(2 * 300 * max(self.left, 0)))
        change = max(-300 * dt, min(300 * dt, wanted - self.speed))
        self.speed += change
        turn = self.wanted_heading - self.heading
        self.heading += max(-60 * dt, min(60 * dt, turn))
        way = self.speed * dt
        if self.left is not None:
            way = min(way, self.left)
            self.left -= way
        self.x += way * math.cos(math.radians(self.heading))
        self.y += way * math.sin(math.radians(self.heading))

    def information(self, number):
        moving = abs(self.speed) > 1
        sonars = [(2 * number) % 16, (2 * number + 1) % 16] if self.sonars else []
        flags = (1 if self.motors else 0) | (6 if self.sonars else 0)
        units = round(self.heading / 360 * 4096)
        data = struct.pack("<hhhhhBHhHbB", round(self.x), round(self.y), units, round(self.speed), round(self.speed), 126, 0,
                           round(self.wanted_heading / 360 * 4096), flags, 0, len(sonars))
        data += b"".join(struct.pack("<BH", sonar, 1000 + 100 * sonar) for sonar in sonars)
        return frame(0x33 if moving else 0x32, data)

    @staticmethod
    def scan():
        """Walls 2 m to the sides and 0.8 m ahead."""
        ranges = []
        for degree in range(-90, 91):
            angle = math.radians(degree)
            ahead = 800 / max(math.cos(angle), 1e-9)
            side = 2000 / max(abs(math.sin(angle)), 1e-9)
            ranges.append(round(min(ahead, side)))
        parts = []
        for first in range(0, 181, 32):
            some = ranges[first:first + 32]
            parts.append(frame(0x61, struct.pack("<HHB", 181, first, len(some)) +
                               b"".join(struct.pack("<HBBB", reading, 20, 0, 0) for reading in some) + bytes([0, 0])))
        return parts


def line(milliseconds, who, packet):
    identity = packet[3]
    return f"{milliseconds:9.1f} {who} id={identity}(0x{identity:02x}) len={packet[2]} ck=ok {packet.hex()}\n"


def conversation(said, end):
    """What the client says, as (s, id, argument) after the handshake, which ends at 0.3 s; `end` in s."""
    said = [(0.3, OPEN, 1), (0.31, CONFIG, 1), *said]
    said += [(0.8 + 0.5 * i, PULSE, None) for i in range(int(2 * (end - 1)))]
    events = []
    for i, sync in enumerate((SYNC0, SYNC1, SYNC2)):
        events.append((0.05 + 0.08 * i, "C>S", command(sync)))
        events.append((0.09 + 0.08 * i, "S>C", frame(sync, NAME if sync == SYNC2 else b"")))
    for time, identity, argument in said:
        events.append((time, "C>S", command(identity, argument)))
    events.append((0.35, "S>C", frame(0x20, configuration())))
    robot, pending, number = Robot(), sorted(said, key=lambda one: one[0]), 0
    closed = False
    for tick in range(int(end * 100)):
        now = tick / 100
        while pending and pending[0][0] <= now:
            _, identity, argument = pending.pop(0)
            closed = closed or (identity == CLOSE and argument is None)
            robot.obey(identity, argument)
        robot.step(0.01)
        if tick % 10 == 0 and now > 0.35 and not closed:
            events.append((now + 0.004, "S>C", robot.information(number)))
            if robot.laser and number % 2 == 0:
                events += [(now + 0.0045, "S>C", part) for part in robot.scan()]
            number += 1
    events.sort(key=lambda event: event[0])
    text = "=== new connection\n" + "".join(line(1000 * time, who, packet) for time, who, packet in events)
    return text + f"{1000 * end:9.1f} client closed\n"


CONVERSATIONS = {
    # Connects, and closes again.
    "connect": ([(0.4, ENABLE, 1), (3.0, CLOSE, None)], 3.2),
    # A meter straight on, half a quarter turn to the left, then 0.2 m/s for two seconds.
    "drive": ([(0.4, ENABLE, 1), (0.5, SETV, 300), (1.0, MOVE, 1000), (6.4, HEAD, 45), (8.4, VEL, 200), (10.4, STOP, None)], 11.5),
    # Asks for the simulator's laser.
    "scans": ([(0.4, LASER_START, -90), (0.41, LASER_END, 90), (0.42, LASER_STEP, 100), (0.43, LASER_ON, 2)], 2.75),
    # Listens to the sonars, then switches them off and closes.
    "sonars": ([(0.4, SONAR, 1), (2.6, SONAR, 0), (3.2, CLOSE, None)], 3.4),
}

if __name__ == "__main__":
    for name, (said, end) in CONVERSATIONS.items():
        (FOLDER / f"{name}.wire").write_text(conversation(said, end))
