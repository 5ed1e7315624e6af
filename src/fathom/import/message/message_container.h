// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/message/message_decoder.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// A stream of messages of one type in a file of ROS or Rock.
struct MessageChannel {
  std::string topic;
  std::string type;        // "geometry_msgs/Pose"; in ROS 2 "geometry_msgs/msg/Pose"
  std::string definition;  // its text; empty: the file does not hold it
  MessageEncoding encoding = MessageEncoding::kRos1;
};

// What a walk over a file found out about it.
struct ContainerWalk {
  std::uint64_t read_bytes = 0;  // up to here it is sound
  std::uint64_t size_bytes = 0;
  std::vector<std::string> remarks;
};

// Takes a message of the channel with this index, with the time at which it was written down [s].
// The bytes last for the call.
using MessageSink = std::function<void(std::size_t channel, double time, std::string_view message)>;

// A file format that holds messages of ROS or Rock.
class MessageContainer {
 public:
  virtual ~MessageContainer() = default;

  virtual std::string format() const = 0;

  // Hands on every message in the order of the file. `channels` grows by each channel before its
  // first message.
  virtual ContainerWalk Walk(std::vector<MessageChannel>* channels,
                             const MessageSink& take) const = 0;

  // The same for a list of what the file holds: of a channel's messages but the first there may be
  // only the times, by an index of the file, in any order and without bytes. What is damaged behind
  // an index, Walk finds.
  virtual ContainerWalk List(std::vector<MessageChannel>* channels, const MessageSink& take) const {
    return Walk(channels, take);
  }
};

}  // namespace fathom
