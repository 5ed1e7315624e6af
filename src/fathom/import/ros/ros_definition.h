// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/message/message_definition.h"

#include <string>
#include <string_view>

namespace fathom {

// From the definition that bags and MCAP files carry: the text of the type's .msg file, then those
// of all types in it, each behind a line of "=" and "MSG: package/Type". Constants and comments are
// left out. Throws InputError, naming the type, for a text that is none, for a type that is not
// there or holds itself, and beyond 1000 types.
MessageDefinition ParseRosDefinition(std::string_view type, std::string_view text);

// The definition of a message type of ROS 2's common interfaces, for files that do not carry it
// (rosbag2 before Iron); empty of any other type. `type`: "nav_msgs/Odometry", or with /msg/ as in
// ROS 2.
std::string KnownDefinition(std::string_view type);

// "nav_msgs/msg/Odometry" is "nav_msgs/Odometry".
std::string WithoutMsg(std::string_view type);

}  // namespace fathom
