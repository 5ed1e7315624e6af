// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/number_type.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace fathom {

// What a member of a message is, in ROS 1, ROS 2 and Rock alike.
enum class MemberKind {
  kNumber,
  kString,
  kWideString,    // of ROS 2
  kTime,          // two numbers of 32 bits: seconds, nanoseconds
  kDuration,      // likewise, signed
  kMicroseconds,  // a time as an integer of 64 bits
  kPadding,       // bytes without a meaning, of Rock; those at the end of a message may be missing
  kMessage,
};

inline constexpr std::int64_t kNoArray = -1;
inline constexpr std::int64_t kSequence = -2;  // its length stands before it

struct MessageMember {
  std::string name;
  MemberKind kind = MemberKind::kNumber;
  NumberType number = NumberType::kUint8;  // of a kNumber
  std::size_t message = 0;                 // index of its type, of a kMessage
  std::int64_t length = kNoArray;          // of a fixed array, from 0 on, or one of the above
};

struct MessageType {
  std::string name;  // "geometry_msgs/Pose"
  std::vector<MessageMember> members;
};

// A message type with all types that it is made of; [0] is the type itself.
using MessageDefinition = std::vector<MessageType>;

}  // namespace fathom
