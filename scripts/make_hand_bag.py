#!/usr/bin/env python3
"""Writes a small bag of ROS 2 as a robot records it: a LEAP hand with AnySkin that grasps objects. The data are
synthetic: computed with added noise, not recorded.

The bag (SQLite, in two files with metadata.yaml) holds

- /joint_states, sensor_msgs/JointState, 50 Hz: 16 joints with positions and efforts
- /anyskin, skin_msgs/Skin, 50 Hz: a pad with five magnetometers on each of two fingers
- /grasp, std_msgs/String: the name of the object when a grasp begins, an empty text when it ends
- /battery, std_msgs/Float32, once a second

usage: make_hand_bag.py FOLDER
"""

import math
import random
import sqlite3
import struct
import sys
from pathlib import Path

JOINTS, MAGNETOMETERS, FINGERS = 16, 5, 2
GRASPS, FRAMES, RATE = 8, 40, 50  # Of each object, of a grasp, a second.
# The closing of the joints (rad) and the field (microtesla) at full closing.
OBJECTS = {"ball": (1.0, 80.0), "bottle": (1.3, 45.0), "sponge": (1.5, 12.0)}
START = 1_700_000_000_000_000_000

RULE = "=" * 80 + "\n"
HEADER = (RULE + "MSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n" + RULE +
          "MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n")
TOPICS = [
    ("/joint_states", "sensor_msgs/msg/JointState",
     "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort\n" + HEADER),
    ("/anyskin", "skin_msgs/msg/Skin",
     "std_msgs/Header header\nPad[] pads\n" + RULE + "MSG: skin_msgs/Pad\nstring finger\nMagnetometer[5] sensors\n" +
     RULE + "MSG: skin_msgs/Magnetometer\nfloat32 x\nfloat32 y\nfloat32 z\nfloat32 temperature\n" + HEADER),
    ("/grasp", "std_msgs/msg/String", "string data\n"),
    ("/battery", "std_msgs/msg/Float32", "float32 data\n"),
]


class Message:
    """A message in CDR: numbers at multiples of their size behind the first four bytes."""

    def __init__(self):
        self.body = bytearray()

    def number(self, kind, *values):
        for value in values:
            size = struct.calcsize(kind)
            self.body += bytes(-len(self.body) % size) + struct.pack("<" + kind, value)
        return self

    def text(self, value):
        self.number("I", len(value) + 1)
        self.body += value.encode() + b"\0"
        return self

    def header(self, time):
        return self.number("i", time // 10**9).number("I", time % 10**9).text("hand")

    def done(self):
        return b"\0\1\0\0" + bytes(self.body)


def joint_state(time, closing, effort, noise):
    message = Message().header(time).number("I", JOINTS)
    for joint in range(JOINTS):
        message.text(f"joint_{joint}")
    message.number("I", JOINTS).number("d", *(closing * (0.5 + joint / JOINTS) + noise(0.01) for joint in range(JOINTS)))
    message.number("I", 0).number("I", JOINTS)
    return message.number("d", *(effort + noise(0.02) for _ in range(JOINTS))).done()


def skin(time, field, noise):
    message = Message().header(time).number("I", FINGERS)
    for finger in ("index", "thumb"):
        message.text(finger)
        for sensor in range(MAGNETOMETERS):
            share = field / (1 + sensor)
            message.number("f", 0.3 * share + noise(1), -0.2 * share + noise(1), share + noise(1), 24.5)
    return message.done()


def messages():
    """(topic, time, data) in the order of recording."""
    random_numbers = random.Random(1)
    noise = lambda deviation: random_numbers.gauss(0, deviation)
    time = START
    for grasp in range(GRASPS * len(OBJECTS)):
        name = list(OBJECTS)[grasp % len(OBJECTS)]
        closing, field = OBJECTS[name]
        yield "/grasp", time, Message().text(name).done()
        for frame in range(FRAMES):
            time += 10**9 // RATE
            share = math.sin(math.pi * frame / FRAMES)
            yield "/joint_states", time, joint_state(time, closing * share, 0.3 * share, noise)
            yield "/anyskin", time + 10**6, skin(time, field * share, noise)
        yield "/grasp", time + 2 * 10**6, Message().text("").done()
        yield "/battery", time + 3 * 10**6, Message().number("f", 12.0 - 0.01 * grasp).done()
        time += 10**9


def write_file(path, rows):
    database = sqlite3.connect(path)
    database.executescript("""
        CREATE TABLE schema(schema_version INTEGER PRIMARY KEY, ros_distro TEXT NOT NULL);
        CREATE TABLE metadata(id INTEGER PRIMARY KEY, metadata_version INTEGER NOT NULL, metadata TEXT NOT NULL);
        CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,
            serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL, type_description_hash TEXT NOT NULL);
        CREATE TABLE message_definitions(id INTEGER PRIMARY KEY, topic_type TEXT NOT NULL, encoding TEXT NOT NULL,
            encoded_message_definition TEXT NOT NULL, type_description_hash TEXT NOT NULL);
        CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL,
            data BLOB NOT NULL);
        CREATE INDEX timestamp_idx ON messages (timestamp ASC);
        INSERT INTO schema VALUES (4, 'jazzy');""")
    ids = {name: number for number, (name, _, _) in enumerate(TOPICS, 1)}
    for name, kind, definition in TOPICS:
        database.execute("INSERT INTO topics VALUES (?, ?, ?, 'cdr', '', '')", (ids[name], name, kind))
        database.execute("INSERT INTO message_definitions VALUES (NULL, ?, 'ros2msg', ?, '')", (kind, definition))
    database.executemany("INSERT INTO messages VALUES (NULL, ?, ?, ?)",
                         ((ids[topic], time, data) for topic, time, data in rows))
    database.commit()
    database.close()


def metadata(files, rows):
    first, last = rows[0][1], rows[-1][1]
    lines = ["rosbag2_bagfile_information:", "  version: 9", "  storage_identifier: sqlite3", "  duration:",
             f"    nanoseconds: {last - first}", "  starting_time:", f"    nanoseconds_since_epoch: {first}",
             f"  message_count: {len(rows)}", "  topics_with_message_count:"]
    for name, kind, _ in TOPICS:
        count = sum(topic == name for topic, _, _ in rows)
        lines += ["    - topic_metadata:", f"        name: {name}", f"        type: {kind}",
                  "        serialization_format: cdr", "        offered_qos_profiles: []",
                  "        type_description_hash: \"\"", f"      message_count: {count}"]
    lines += ["  compression_format: \"\"", "  compression_mode: \"\"", "  relative_file_paths:"]
    lines += [f"    - {file}" for file in files] + ["  files: []", "  custom_data: ~", "  ros_distro: jazzy", ""]
    return "\n".join(lines)


def main():
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True)
    rows = list(messages())
    half = len(rows) // 2
    files = [f"{folder.name}_{part}.db3" for part in range(2)]
    for file, part in zip(files, (rows[:half], rows[half:])):
        write_file(folder / file, part)
    (folder / "metadata.yaml").write_text(metadata(files, rows))


if __name__ == "__main__":
    main()
