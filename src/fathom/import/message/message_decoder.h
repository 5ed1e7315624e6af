// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/message/message_definition.h"
#include "fathom/import/recording/recording.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// How the bytes of a message follow each other.
enum class MessageEncoding {
  kRos1,     // packed, the least significant byte first
  kCdr,      // of ROS 2: four bytes that say the order of bytes, then numbers at multiples of their
             // size
  kTypelib,  // of Rock: as the program had it in memory, the least significant byte first, and
             // lengths of 8 bytes
};

// The numbers of a message by their paths: "pose.pose.position.x", "data[3]", "header.stamp" [s].
// Texts are none. Of a sequence those are listed that this message has, up to 32 elements.
std::vector<Field> NumbersOf(const MessageDefinition& definition,
                             MessageEncoding encoding,
                             std::string_view message);

// Takes some numbers out of messages of one type.
class MessageDecoder {
 public:
  MessageDecoder(const MessageDefinition& definition,
                 MessageEncoding encoding,
                 const std::vector<std::string>& paths);
  ~MessageDecoder();
  MessageDecoder(MessageDecoder&&) noexcept;
  MessageDecoder& operator=(MessageDecoder&&) noexcept;

  // The numbers in the order of the paths, NaN for an element that a sequence has not. False if the
  // message ends too early or is none.
  bool Decode(std::string_view message, std::vector<double>* values) const;

 private:
  struct Plan;

  const MessageDefinition* definition_;  // outlives this
  MessageEncoding encoding_;
  std::size_t num_values_;
  std::unique_ptr<Plan> plan_;
};

}  // namespace fathom
