// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// What a member of a ROS message is, in ROS 1 and ROS 2 alike.
enum class RosKind {
  kBool,
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kUint64,
  kFloat32,
  kFloat64,
  kString,
  kWideString,  // of ROS 2
  kTime,        // two numbers of 32 bits: seconds, nanoseconds
  kDuration,    // likewise, signed
  kMessage,
};

// Bytes of a number; 0 of strings and messages. A time is its two halves of 4 bytes each.
std::size_t SizeOf(RosKind kind);

inline constexpr std::int64_t kNoArray = -1;
inline constexpr std::int64_t kSequence = -2;  // its length stands before it

struct RosMember {
  std::string name;
  RosKind kind = RosKind::kBool;
  std::size_t message = 0;         // index of its type, of a kMessage
  std::int64_t length = kNoArray;  // of a fixed array, from 0 on, or one of the above
};

struct RosMessage {
  std::string name;  // "geometry_msgs/Pose"
  std::vector<RosMember> members;
};

// A message type with all types that it is made of; [0] is the type itself.
using RosDefinition = std::vector<RosMessage>;

// From the definition that bags and MCAP files carry: the text of the type's .msg file, then those
// of all types in it, each behind a line of "=" and "MSG: package/Type". Constants and comments are
// left out. Throws InputError, naming the type, for a text that is none, for a type that is not
// there or holds itself, and beyond 1000 types.
RosDefinition ParseRosDefinition(std::string_view type, std::string_view text);

}  // namespace fathom
