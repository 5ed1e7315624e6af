// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>

namespace fathom {

// The definition of a message type of ROS 2's common interfaces, for files that do not carry it
// (rosbag2 before Iron); empty of any other type. `type`: "nav_msgs/Odometry", or with /msg/ as in
// ROS 2.
std::string KnownDefinition(std::string_view type);

// "nav_msgs/msg/Odometry" is "nav_msgs/Odometry".
std::string WithoutMsg(std::string_view type);

}  // namespace fathom
