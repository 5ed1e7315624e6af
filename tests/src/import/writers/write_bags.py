#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Fathom authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes bags with ROS's own rosbag, and expected.json with what stands in them, into a folder.

  write_bags.py FOLDER

Debian's python3-rosbag, python3-nav-msgs and python3-sensor-msgs; exit 77 where one is missing.
"""

import json
import math
import os
import shutil
import struct
import sys

try:
    import genpy
    import genpy.dynamic
    import rosbag
    from nav_msgs.msg import Odometry
    from sensor_msgs.msg import Image, JointState
    from std_msgs.msg import Float64, Header
except ImportError as error:
    print(error, file=sys.stderr)
    sys.exit(77)

# Of a sequence 32 elements are fields, of an array of fixed length 64.
MOST_OF_SEQUENCE, MOST_OF_ARRAY = 32, 64

EVERY_TYPE = """
int32 CONSTANT=5
string NAME=a # b
Header header
bool a
int8 b
uint8 c
int16 d
uint16 e
int32 f
uint32 g
int64 h
uint64 i
float32 j
float64 k
time l
duration m
string n
char o
byte p
float64[] doubles
int16[4] shorts
uint8[] bytes
time[] times
string[] words
fathom/Inner inner
fathom/Inner[] inners
fathom/Inner[2] pair
float64 last
================================================================================
MSG: std_msgs/Header
uint32 seq
time stamp
string frame_id
================================================================================
MSG: fathom/Inner
string word
float32[] x
int8 y
"""
TYPES = genpy.dynamic.generate_dynamic("fathom/Every", EVERY_TYPE)
Every, Inner = TYPES["fathom/Every"], TYPES["fathom/Inner"]


def stamp(k):
    return genpy.Time(1500000000 + k // 10, 100000000 * (k % 10) + 7)


def header(k):
    return Header(seq=k, stamp=stamp(k), frame_id="odom")


def odometry(k):
    message = Odometry(header=header(k), child_frame_id="base_link" * (k % 3))
    message.pose.pose.position.x, message.pose.pose.position.z = math.sin(k), -0.1 * k
    message.pose.pose.orientation.w = 1.0 / (k + 1)
    message.pose.covariance = [0.1 * k + j for j in range(36)]
    message.twist.twist.linear.y = math.cos(k)
    return message


def joints(k):
    names = ["thruster_%d" % i for i in range(k % 4 + (k == 0))]
    return JointState(header=header(k), name=names, position=[0.1 * k + j for j in range(len(names))],
                      velocity=[], effort=[-k, 1e300])


def image(k):
    return Image(header=header(k), height=50, width=100, encoding="mono8", step=100,
                 data=bytes((k + j) % 256 for j in range(5000)))


def every(k):
    message = Every(a=k % 2 == 1, b=-k, c=255 - k, d=-32768 + k, e=65535 - k, f=-2**31 + k,
                    g=2**32 - 1 - k, h=-2**63 + k, i=2**64 - 1 - k, j=0.1, k=0.1 * k,
                    l=stamp(k), m=genpy.Duration(-k, 5), n="x" * k, o=k, p=-k,
                    doubles=[0.5 * j for j in range((7 * k + 3) % 40)],
                    shorts=[k, -k, 1, 2], bytes=bytes(range(k % 5)),
                    times=[stamp(j) for j in range(k % 3)], words=["a", "bcd"] * (k % 3),
                    last=math.pi * k)
    message.header.stamp = stamp(k)
    inners = [Inner(word="w" * j, x=[1.5 * k] * ((j + k) % 3), y=j) for j in range(4)]
    message.inner, message.inners, message.pair = inners[0], inners[:1 + k % 3], inners[1:3]
    return message


def seconds(time):
    return time.secs + 1e-9 * time.nsecs


def numbers_of(value, kind, path, out):
    """The numbers of a member, by path."""
    if kind.endswith("]"):
        kind, size = kind[:-1].split("[")
        if kind == "string":
            return
        most = MOST_OF_ARRAY if size else MOST_OF_SEQUENCE
        for i, element in enumerate(list(value)[:most]):
            numbers_of(element, kind, "%s[%d]" % (path, i), out)
    elif kind in ("time", "duration"):
        out[path] = seconds(value)
    elif hasattr(value, "_slot_types"):
        for name, inner in zip(value.__slots__, value._slot_types):
            numbers_of(getattr(value, name), inner, (path + "." if path else "") + name, out)
    elif kind != "string":
        # A float32 is what reading it back gives.
        is_single = kind == "float32"
        out[path] = struct.unpack("f", struct.pack("f", value))[0] if is_single else value + 0


class Expected:
    """What a bag holds: by topic the stamps and the numbers, null where a sequence has no more."""

    def __init__(self):
        self.channels = {}

    def add(self, topic, message, time):
        numbers = {}
        numbers_of(message, message._type, "", numbers)
        channel = self.channels.setdefault(topic, {
            "type": message._type, "time": [], "fields": {name: [] for name in numbers}})
        channel["time"].append(seconds(time))
        for name, values in channel["fields"].items():
            values.append(numbers.get(name))


def fill(bag, expected, first=0, count=60):
    for k in range(first, first + count):
        for topic, make in [("/odom", odometry), ("/joints", joints), ("/image", image),
                            ("/every", every)]:
            message, time = make(k), stamp(k) + genpy.Duration(0, 12345)
            bag.write(topic, message, time)
            expected.add(topic, message, time)
        # A second publisher of a topic has a connection of its own, which rosbag writes only when
        # it does not find the first one.
        bag._topic_connections.pop("/depth", None)
        bag.write("/depth", Float64(0.25 * k), stamp(k))
        expected.add("/depth", Float64(0.25 * k), stamp(k))


def main(folder):
    files = {}

    def note(name, expected, remarks=()):
        files[name] = {"format": "ros1_bag", "channels": expected.channels,
                       "remarks": list(remarks)}

    for compression in ("none", "bz2", "lz4"):
        for size in (4096, 786432):
            name, expected = "%s_%d.bag" % (compression, size), Expected()
            path = os.path.join(folder, name)
            with rosbag.Bag(path, "w", compression=compression, chunk_threshold=size) as bag:
                fill(bag, expected)
            note(name, expected)
        # As a recorder leaves it that is killed: whole chunks, and no index.
        bag = rosbag.Bag(os.path.join(folder, "open.tmp"), "w", compression=compression)
        expected, name = Expected(), "killed_%s.bag" % compression
        fill(bag, expected)
        bag.flush()
        bag._file.flush()
        shutil.copy(os.path.join(folder, "open.tmp"), os.path.join(folder, name))
        bag.close()
        os.remove(os.path.join(folder, "open.tmp"))
        note(name, expected, ["has no index"])
    # Appending takes the index away and writes it anew.
    expected, path = Expected(), os.path.join(folder, "appended.bag")
    with rosbag.Bag(path, "w", compression="lz4") as bag:
        fill(bag, expected)
    with rosbag.Bag(path, "a", compression="none") as bag:
        fill(bag, expected, 60, 20)
    note("appended.bag", expected)
    with open(os.path.join(folder, "expected.json"), "w") as file:
        json.dump(files, file)


main(sys.argv[1])
