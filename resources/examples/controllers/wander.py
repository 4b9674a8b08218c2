#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A controller of a simulation as a program of its own: lets a robot on wheels wander without hitting anything.

    robotctl sim pioneer --listen 8765 &
    wander.py 8765 p3at1

It speaks the Foxglove WebSocket protocol (robotlink/foxglove/FOXGLOVE.md) with Python's own library alone: it attaches itself by the service
attach_controller, gets readings on the stream sim/ports/wander, and answers each of them by set_ports. In lockstep (the default) the
simulation waits for each answer, so that the same scene and seed give the same run; with --free it does not.
"""
import argparse
import base64
import json
import os
import socket
import struct
import sys

NEAR, SPEED = 0.8, 0.4  # m, m/s
CALL, MESSAGE = 2, 1  # opcodes of binary messages: client to server, server to client


class Link:
    """A connection with a server of the Foxglove WebSocket protocol."""

    def __init__(self, host, port):
        try:
            self.socket = socket.create_connection((host, port))
        except OSError as error:
            sys.exit(f"wander.py: nobody listens at {host}:{port} ({error}); start robotctl sim SCENE --listen {port}")
        self.file = self.socket.makefile("rb")
        self.channels, self.services, self.subscriptions = {}, {}, {}
        key = base64.b64encode(os.urandom(16)).decode()
        self.socket.sendall((f"GET / HTTP/1.1\r\nHost: {host}:{port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                             f"Sec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n"
                             "Sec-WebSocket-Protocol: foxglove.sdk.v1\r\n\r\n").encode())
        if b" 101 " not in self.file.readline():
            sys.exit("wander.py: the server refuses the connection")
        while self.file.readline().strip():
            pass

    def send(self, payload, opcode):
        mask = os.urandom(4)
        size = len(payload)
        if size < 126:
            head = struct.pack("!BB", 0x80 | opcode, 0x80 | size)
        elif size < 65536:
            head = struct.pack("!BBH", 0x80 | opcode, 0x80 | 126, size)
        else:
            head = struct.pack("!BBQ", 0x80 | opcode, 0x80 | 127, size)
        self.socket.sendall(head + mask + bytes(byte ^ mask[i % 4] for i, byte in enumerate(payload)))

    def frame(self):
        first, second = self.file.read(2)
        size = second & 127
        if size == 126:
            size, = struct.unpack("!H", self.file.read(2))
        elif size == 127:
            size, = struct.unpack("!Q", self.file.read(8))
        return bool(first & 0x80), first & 15, self.file.read(size)

    def receive(self):
        """The next text or binary message, as (opcode, bytes)."""
        kind, whole = 0, b""
        while True:
            final, opcode, payload = self.frame()
            if opcode == 8:
                sys.exit("wander.py: the server has ended the connection")
            if opcode == 9:
                self.send(payload, 10)
            if opcode > 2:
                continue
            kind, whole = kind or opcode, whole + payload
            if final:
                return kind, whole

    def tell(self, **message):
        self.send(json.dumps(message).encode(), 1)

    def call(self, service, **argument):
        """Calls a service; what it answers comes as a message, and is only looked at where it is refused."""
        encoding, payload = b"json", json.dumps(argument).encode()
        self.send(struct.pack("<BIII", CALL, self.services[service], 1, len(encoding)) + encoding + payload, 2)

    def notice(self, message):
        """Keeps what the server offers; returns the names of what is new."""
        new = []
        for channel in message.get("channels", []) if message["op"] == "advertise" else []:
            self.channels[channel["topic"]] = channel["id"]
            new.append(channel["topic"])
        for service in message.get("services", []) if message["op"] == "advertiseServices" else []:
            self.services[service["name"]] = service["id"]
            new.append(service["name"])
        if message["op"] in ("serviceCallFailure", "status"):
            print("wander.py:", message.get("message"), file=sys.stderr)
        return new

    def subscribe(self, topic):
        self.subscriptions[1] = topic
        self.tell(op="subscribe", subscriptions=[{"id": 1, "channelId": self.channels[topic]}])


def varint(data, at):
    value = shift = 0
    while True:
        byte = data[at]
        value |= (byte & 127) << shift
        at, shift = at + 1, shift + 7
        if byte < 128:
            return value, at


def fields(data):
    """The fields of a serialized Protobuf message: (number, value)."""
    at = 0
    while at < len(data):
        tag, at = varint(data, at)
        if tag & 7 == 0:
            value, at = varint(data, at)
        else:
            size, at = (8, at) if tag & 7 == 1 else varint(data, at)
            value, at = data[at:at + size], at + size
        yield tag >> 3, value


def inputs_of(payload):
    """Step and readings of a robotcontrol.ControllerInputs (robotcontrol/World.proto)."""
    step, readings = 0, {}
    for number, value in fields(payload):
        if number == 2:
            step = value
        if number == 3:
            reading = dict(fields(value))
            values = reading.get(2, b"")
            readings[reading[1].decode()] = struct.unpack(f"<{len(values) // 8}d", values)
    return step, readings


def decide(ranges):
    """The speeds of the left and the right wheels."""
    middle = len(ranges) // 2
    right, left = min(ranges[:middle + 1]), min(ranges[middle:])
    if min(left, right) > NEAR:
        return SPEED, SPEED
    return (-0.2, 0.2) if left > right else (0.2, -0.2)


def main():
    parser = argparse.ArgumentParser(description="Lets a robot of a simulation wander")
    parser.add_argument("port", type=int, help="that of robotctl sim --listen PORT")
    parser.add_argument("robot", help="its name: p3at1")
    parser.add_argument("--host", default="127.0.0.1")
    parser.add_argument("--free", action="store_true", help="the simulation does not wait for answers")
    parser.add_argument("--start", action="store_true", help="starts the simulation, as one of robotctl sim --listen --paused")
    parser.add_argument("--steps", type=int, default=0, help="ends after so many answers; 0: never")
    options = parser.parse_args()
    laser, drive = options.robot + "/laser", options.robot + "/drive"
    link, answers = Link(options.host, options.port), 0
    while not options.steps or answers < options.steps:
        kind, payload = link.receive()
        if kind == 1:
            new = link.notice(json.loads(payload))
            if "attach_controller" in new:
                link.call("attach_controller", name="wander", sensors=[laser], lockstep=not options.free, every=5,
                          outputs=[{"path": "nearest", "type": "distance", "unit": "m", "maximum": 10}])
            if "sim/ports/wander" in new:
                link.subscribe("sim/ports/wander")
                if options.start:
                    link.call("control_simulation", action="START")
        elif payload[0] == MESSAGE:
            step, readings = inputs_of(payload[13:])
            if laser not in readings:  # the last message of a controller that had this name before
                continue
            ranges = readings[laser]
            link.call("set_ports", controller="wander", step=step,
                      commands=[{"port": drive, "values": decide(ranges)}],
                      outputs=[{"port": "nearest", "values": [min(ranges)]}])
            answers += 1
        elif b'"accepted":false' in payload:
            refusal = "wander.py: " + payload[payload.index(b"{"):].decode()
            if not answers:
                sys.exit(refusal)
            print(refusal, file=sys.stderr)
    link.call("attach_controller", name="wander", ended=True)


if __name__ == "__main__":
    main()
