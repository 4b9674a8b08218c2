#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Drives a Pioneer over its ARCOS port with nothing but Python: straight on, and turning where sonars hear something ahead.

Usage: drive.py [tcp://localhost:8101] [SECONDS]
"""
import socket
import struct
import sys
import time
from urllib.parse import urlsplit

SYNC0, SYNC1, SYNC2 = 0, 1, 2  # the handshake; afterwards 0 to 2 are PULSE, OPEN and CLOSE
PULSE, OPEN, CLOSE, ENABLE, VEL, RVEL, SONAR = 0, 1, 2, 4, 11, 21, 28


def checksum(body):
    """Of id and data: the sum of big-endian pairs; the last byte is xored if it is left alone."""
    total = 0
    for i in range(0, len(body) - 1, 2):
        total = (total + (body[i] << 8 | body[i + 1])) & 0xFFFF
    return total ^ body[-1] if len(body) % 2 else total


def packet(identifier, argument=None):
    """A command: an integer argument goes as its sign (0x3B, 0x1B) and its magnitude."""
    body = bytes([identifier])
    if argument is not None:
        body += struct.pack("<BH", 0x3B if argument >= 0 else 0x1B, abs(argument))
    return b"\xfa\xfb" + bytes([len(body) + 2]) + body + struct.pack(">H", checksum(body))


class Pioneer:
    def __init__(self, url):
        address = urlsplit(url if "//" in url else "//" + url)
        self.line = socket.create_connection((address.hostname, address.port or 8101), timeout=5)
        self.line.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.buffer = b""
        self.sonars = {}  # number: m
        for number in (SYNC0, SYNC1, SYNC2):
            self.send(number)
            answer = self.receive()
            while answer[0] != number:
                answer = self.receive()
        self.name, _, self.subclass = [text.decode() for text in answer[1:].split(b"\0")[:3]]
        self.send(OPEN, 1)

    def send(self, identifier, argument=None):
        self.line.sendall(packet(identifier, argument))

    def receive(self):
        """The id and the data of the next packet; what is no packet is skipped."""
        while True:
            start = self.buffer.find(b"\xfa\xfb")
            self.buffer = self.buffer[start:] if start >= 0 else self.buffer[-1:]
            if len(self.buffer) >= 3 and len(self.buffer) >= 3 + self.buffer[2]:
                end = 3 + self.buffer[2]
                body, check = self.buffer[3:end - 2], self.buffer[end - 2:end]
                if body and struct.pack(">H", checksum(body)) == check:
                    self.buffer = self.buffer[end:]
                    return body
                self.buffer = self.buffer[2:]  # damaged: look for the next header
                continue
            received = self.line.recv(4096)
            if not received:
                raise ConnectionError("the robot closed the connection")
            self.buffer += received

    def read(self):
        """Waits for the next state, which comes each 100 ms, and keeps the robot's watchdog content."""
        body = self.receive()
        while body[0] not in (0x32, 0x33):
            body = self.receive()
        self.send(PULSE)
        x, y, heading, left, right, battery, _, _, flags, _, count = struct.unpack_from("<5hBHhHBB", body, 1)
        self.x, self.y, self.heading = x / 1000, y / 1000, heading * 360 / 4096
        self.speed, self.battery, self.motors_on = (left + right) / 2000, battery / 10, bool(flags & 1)
        for i in range(count):
            number, millimeters = struct.unpack_from("<BH", body, 20 + 3 * i)
            self.sonars[number] = millimeters / 1000

    def close(self):
        self.send(ENABLE, 0)
        self.send(CLOSE)
        self.line.close()


def main():
    robot = Pioneer(sys.argv[1] if len(sys.argv) > 1 else "tcp://localhost:8101")
    end = time.monotonic() + float(sys.argv[2] if len(sys.argv) > 2 else 30)
    print(f"connected to {robot.name}, a {robot.subclass}")
    robot.send(ENABLE, 1)
    robot.send(SONAR, 1)
    while time.monotonic() < end:
        robot.read()  # sense
        ahead = min((robot.sonars.get(number, 5.0) for number in range(2, 6)), default=5.0)  # plan
        robot.send(VEL, 250 if ahead > 1 else 0)  # act: mm/s and degrees/s
        robot.send(RVEL, 0 if ahead > 1 else 30)
    print(f"at {robot.x:.2f} m, {robot.y:.2f} m, {robot.heading:.0f} degrees, battery {robot.battery:.1f} V")
    robot.close()


if __name__ == "__main__":
    try:
        main()
    except (OSError, ConnectionError) as error:
        sys.exit(f"the robot cannot be driven: {error}")
