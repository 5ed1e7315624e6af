#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Fathom authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reads every message of a bag with ROS's rosbag (Debian's python3-rosbag), for bench/import_bench.

  read_bag.py FILE

Prints how many messages there were.
"""

import sys

import rosbag

with rosbag.Bag(sys.argv[1]) as bag:
    print(sum(1 for _ in bag.read_messages()))
