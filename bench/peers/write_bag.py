#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Fathom authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes a bag of odometry with ROS's rosbag (Debian's python3-rosbag, python3-nav-msgs), for
bench/import_bench: with the index and the check sums that rosbag asks for when it reads one.

  write_bag.py FILE COMPRESSION MESSAGES
"""

import math
import sys

import genpy
import rosbag
from nav_msgs.msg import Odometry

path, compression, count = sys.argv[1], sys.argv[2], int(sys.argv[3])
with rosbag.Bag(path, "w", compression=compression) as bag:
    message = Odometry()
    message.header.frame_id, message.child_frame_id = "odom", "base_link"
    for k in range(count):
        stamp = genpy.Time(1500000000 + k // 100, k % 100 * 10000000)
        message.header.seq, message.header.stamp = k, stamp
        message.pose.pose.position.x = 0.01 * k
        message.twist.twist.linear.x = math.sin(0.01 * k)
        bag.write("/odom", message, stamp)
