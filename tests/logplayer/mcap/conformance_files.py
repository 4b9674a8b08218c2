#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes MCAP files of every combination of the format's optional parts, and says what is in them.

It knows of the format only what its specification says (mcap.dev/spec), and shares no code with the library that the tests
check with it. The files have the layout of the MCAP project's conformance suite, as has the list of what is in them.
Usage: conformance_files.py FOLDER
"""
import itertools
import json
import pathlib
import struct
import sys
import zlib

MAGIC = b"\x89MCAP0\r\n"
PADDING = bytes([0x01, 0xFF, 0xFF])
OPCODES = {"Header": 1, "Footer": 2, "Schema": 3, "Channel": 4, "Message": 5, "Chunk": 6, "MessageIndex": 7, "ChunkIndex": 8,
           "Attachment": 9, "AttachmentIndex": 10, "Statistics": 11, "Metadata": 12, "MetadataIndex": 13, "SummaryOffset": 14,
           "DataEnd": 15}


def text(value):
    data = value.encode() if isinstance(value, str) else value
    return struct.pack("<I", len(data)) + data


def mapping(entries):
    return text(b"".join(text(key) + text(value) for key, value in sorted(entries.items())))


def numbers(key_format, entries):
    return text(b"".join(struct.pack("<" + key_format, key, value) for key, value in entries))


# How the fields of each kind of record are written: their names, and their formats of struct or functions of above.
FIELDS = {
    "Header": [("profile", text), ("library", text)],
    "Schema": [("id", "H"), ("name", text), ("encoding", text), ("data", text)],
    "Channel": [("id", "H"), ("schema_id", "H"), ("topic", text), ("message_encoding", text), ("metadata", mapping)],
    "Message": [("channel_id", "H"), ("sequence", "I"), ("log_time", "Q"), ("publish_time", "Q"), ("data", bytes)],
    "Metadata": [("name", text), ("metadata", mapping)],
    "DataEnd": [("data_section_crc", "I")],
    "ChunkIndex": [("message_start_time", "Q"), ("message_end_time", "Q"), ("chunk_start_offset", "Q"), ("chunk_length", "Q"),
                   ("message_index_offsets", lambda offsets: numbers("HQ", offsets.items())), ("message_index_length", "Q"),
                   ("compression", text), ("compressed_size", "Q"), ("uncompressed_size", "Q")],
    "AttachmentIndex": [("offset", "Q"), ("length", "Q"), ("log_time", "Q"), ("create_time", "Q"), ("data_size", "Q"),
                        ("name", text), ("media_type", text)],
    "Statistics": [("message_count", "Q"), ("schema_count", "H"), ("channel_count", "I"), ("attachment_count", "I"),
                   ("metadata_count", "I"), ("chunk_count", "I"), ("message_start_time", "Q"), ("message_end_time", "Q"),
                   ("channel_message_counts", lambda counts: numbers("HQ", sorted(counts.items())))],
    "MetadataIndex": [("offset", "Q"), ("length", "Q"), ("name", text)],
    "SummaryOffset": [("group_opcode", "B"), ("group_start", "Q"), ("group_length", "Q")],
    "Footer": [("summary_start", "Q"), ("summary_offset_start", "Q"), ("summary_crc", "I")],
}


def framed(kind, content, padding=b""):
    return struct.pack("<BQ", OPCODES[kind], len(content) + len(padding)) + content + padding


def written(kind, fields, padding=b""):
    if kind == "Attachment":
        content = struct.pack("<QQ", fields["log_time"], fields["create_time"]) + text(fields["name"]) + \
            text(fields["media_type"]) + struct.pack("<Q", len(fields["data"])) + fields["data"]
        return framed(kind, content + struct.pack("<I", zlib.crc32(content)), padding)
    content = b"".join(how(fields[name]) if callable(how) else struct.pack("<" + how, fields[name])
                       for name, how in FIELDS[kind])
    return framed(kind, content, padding)


class File:
    """A file of some contents with some of the format's optional parts."""

    def __init__(self, contents, features):
        self.contents, self.features = contents, features
        self.padding = PADDING if "pad" in features else b""
        self.data, self.records, self.offsets = bytearray(MAGIC), [], []
        self.attachments, self.metadata, self.chunks = [], [], []

    def add(self, kind, fields, padding=None):
        self.records.append((kind, fields))
        self.data += written(kind, fields, self.padding if padding is None else padding)

    def of(self, *kinds):
        return [(kind, fields) for kind, fields in self.contents if kind in kinds]

    def add_messages(self):
        for kind, fields in self.of("Schema", "Channel", "Message"):
            self.add(kind, fields, b"" if kind == "Message" else None)

    def add_chunk(self):
        records, indexes = b"", {}
        for kind, fields in self.of("Schema", "Channel", "Message"):
            if kind == "Channel":
                indexes[fields["id"]] = []
            if kind == "Message":
                indexes[fields["channel_id"]].append((fields["log_time"], len(records)))
            records += written(kind, fields)
            self.records.append((kind, fields))
        start, (first, last) = len(self.data), self.times()
        self.data += framed("Chunk", struct.pack("<QQQI", first, last, len(records), zlib.crc32(records)) + text("") +
                            struct.pack("<Q", len(records)) + records)
        index = {"message_start_time": first, "message_end_time": last, "chunk_start_offset": start,
                 "chunk_length": len(self.data) - start, "message_index_offsets": {}, "compression": "",
                 "compressed_size": len(records), "uncompressed_size": len(records)}
        for channel, entries in indexes.items() if "mx" in self.features else ():
            index["message_index_offsets"][channel] = len(self.data)
            self.data += framed("MessageIndex", struct.pack("<H", channel) + numbers("QQ", entries), self.padding)
        index["message_index_length"] = len(self.data) - start - index["chunk_length"]
        self.chunks.append(index)

    def add_others(self):
        for kind, fields in self.of("Attachment", "Metadata"):
            start = len(self.data)
            self.add(kind, fields)
            index = {"offset": start, "length": len(self.data) - start, "name": fields["name"]}
            if kind == "Attachment":
                index.update({key: fields[key] for key in ("log_time", "create_time", "media_type")},
                             data_size=len(fields["data"]))
            (self.attachments if kind == "Attachment" else self.metadata).append(index)

    def times(self):
        times = [fields["log_time"] for _, fields in self.of("Message")]
        return (min(times), max(times)) if times else (0, 0)

    def statistics(self):
        first, last = self.times()
        counts = {}
        for _, message in self.of("Message"):
            counts[message["channel_id"]] = counts.get(message["channel_id"], 0) + 1
        return {"message_count": len(self.of("Message")), "schema_count": len(self.of("Schema")),
                "channel_count": len(self.of("Channel")), "attachment_count": len(self.attachments),
                "metadata_count": len(self.metadata), "chunk_count": len(self.chunks), "message_start_time": first,
                "message_end_time": last, "channel_message_counts": counts}

    def add_group(self, kind, records):
        start = len(self.data)
        for fields in records:
            self.add(kind, fields)
        if records:
            self.offsets.append({"group_opcode": OPCODES[kind], "group_start": start, "group_length": len(self.data) - start})

    def add_summary(self):
        start = len(self.data)
        groups = [("rsh", "Schema", [f for _, f in self.of("Schema")]), ("rch", "Channel", [f for _, f in self.of("Channel")]),
                  ("st", "Statistics", [self.statistics()]), ("mdx", "MetadataIndex", self.metadata),
                  ("ax", "AttachmentIndex", self.attachments), ("chx", "ChunkIndex", self.chunks)]
        for feature, kind, records in groups:
            if feature in self.features:
                self.add_group(kind, records)
        offsets = len(self.data)
        for offset in self.offsets if "sum" in self.features else ():
            self.add("SummaryOffset", offset)
        footer = {"summary_start": start if offsets > start else 0,
                  "summary_offset_start": offsets if len(self.data) > offsets else 0, "summary_crc": 0}
        covered = self.data[start:] + written("Footer", footer)[:-4]
        footer["summary_crc"] = zlib.crc32(covered)
        self.add("Footer", footer, b"")

    def write(self):
        self.add("Header", {"profile": "", "library": ""})
        if "ch" not in self.features:
            self.add_messages()
        self.add_others()
        if "ch" in self.features:
            self.add_chunk()
        self.add("DataEnd", {"data_section_crc": zlib.crc32(self.data)}, b"")
        self.add_summary()
        return bytes(self.data) + MAGIC


def plain(value):
    """A field as the list of what is in the files has it: numbers as text, bytes as a list."""
    if isinstance(value, bytes):
        return [str(byte) for byte in value]
    if isinstance(value, dict):
        return {str(key): plain(entry) for key, entry in value.items()}
    return str(value)


def message(channel, sequence, log_time, data):
    return "Message", {"channel_id": channel, "sequence": sequence, "log_time": log_time, "publish_time": log_time + 5,
                       "data": data}


SCHEMA = ("Schema", {"id": 1, "name": "Ball", "encoding": "protobuf", "data": b"\x0a\x00\xff"})
ATTACHMENT = ("Attachment", {"log_time": 70, "create_time": 65, "name": "notes.txt", "media_type": "text/plain",
                             "data": b"ball lost"})
METADATA = ("Metadata", {"name": "game", "metadata": {"half": "2", "side": "left"}})


def channel(number, schema, topic, metadata):
    return "Channel", {"id": number, "schema_id": schema, "topic": topic, "message_encoding": "json", "metadata": metadata}


# Messages out of the order of time, two at the same instant, one without data, one without a schema.
GAME = [SCHEMA, channel(1, 1, "red1/models/ball", {"process": "cognition"}), message(1, 7, 40, b"{}"), message(1, 8, 20, b""),
        channel(3, 0, "scene", {}), message(3, 0, 20, bytes(range(200))), message(1, 9, 90, b"\x00\x01"),
        message(3, 1, 41, b"x"), ATTACHMENT, METADATA]
CONTENTS = {"Nothing": ([], ["st", "sum", "pad"]),
            "Attachment": ([ATTACHMENT], ["ax", "st", "sum", "pad"]),
            "Metadata": ([METADATA], ["mdx", "st", "sum", "pad"]),
            "Game": (GAME, ["ch", "mx", "st", "rsh", "rch", "ax", "mdx", "chx", "sum", "pad"])}


def possible(features):
    chunked = "ch" in features or not features & {"mx", "chx"}
    summed = "sum" not in features or features & {"st", "rsh", "rch", "ax", "mdx", "chx"}
    # Indexes of what is beside the messages go together in the larger files: that makes a quarter of them.
    return chunked and summed and ("ch" not in features or ("ax" in features) == ("mdx" in features))


def main():
    folder = pathlib.Path(sys.argv[1])
    cases = []
    for name, (contents, features) in CONTENTS.items():
        for count in range(len(features) + 1):
            for chosen in itertools.combinations(features, count):
                if not possible(set(chosen)):
                    continue
                file = File(contents, set(chosen))
                data = file.write()
                case = "-".join([name, *chosen])
                (folder / f"{case}.mcap").write_bytes(data)
                records = [{"type": kind, "fields": [[key, value if isinstance(value, str) else plain(value)]
                                                     for key, value in fields.items()]} for kind, fields in file.records]
                cases.append({"name": case, "features": list(chosen), "records": records})
    (folder / "answers.json").write_text(json.dumps(cases))


if __name__ == "__main__":
    main()
