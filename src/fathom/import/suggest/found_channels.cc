// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/suggest/found_channels.h"

#include "fathom/import/ros/ros_definition.h"
#include "fathom/import/suggest/channel_facts.h"

#include <algorithm>

namespace fathom {
namespace {

constexpr int kMostCounted = 16;  // outputs of mavros and of PX4

bool Fits(const WantedChannel& wanted, const Channel& channel) {
  if (channel.count < 2 || (!wanted.name.empty() && channel.name != wanted.name)) return false;
  if (!wanted.field.empty() && !HasField(channel, wanted.field)) return false;
  if (wanted.type.empty()) return true;
  std::string type = WithoutMsg(channel.type);
  if (type.ends_with("_m")) type.resize(type.size() - 2);  // marshalled by way of another
  return type == wanted.type;
}

}  // namespace

FoundChannels::FoundChannels(const Recording& recording,
                             const WantedChannels& wanted,
                             bool takes_most)
    : recording_(recording), wanted_(wanted), takes_most_(takes_most) {}

const FoundChannel& FoundChannels::Of(std::string_view name) {
  if (const auto known = found_.find(name); known != found_.end()) return known->second;
  const auto ways = wanted_.find(name);
  FoundChannel found = ways == wanted_.end() ? FoundChannel() : Find(ways->second);
  return found_.emplace(name, std::move(found)).first->second;
}

FoundChannel FoundChannels::Find(const std::vector<WantedChannel>& ways) const {
  FoundChannel taken;
  std::size_t num_all = 0;
  for (const WantedChannel& wanted : ways) {
    FoundChannel found;
    found.wanted = &wanted;
    for (const Channel& channel : recording_.contents().channels) {
      if (!Fits(wanted, channel)) continue;
      ++num_all;
      const bool is_better = takes_most_ && found.channel && channel.count > found.channel->count;
      if (found.channel == nullptr || is_better) found.channel = &channel;
    }
    if (taken.channel == nullptr && found.channel != nullptr && MeetsItsNumbers(&found)) {
      taken = std::move(found);
    }
  }
  if (taken.channel != nullptr) taken.num_others = num_all - 1;
  return taken;
}

bool FoundChannels::MeetsItsNumbers(FoundChannel* found) const {
  const WantedChannel& wanted = *found->wanted;
  const std::string& name = found->channel->name;
  if (wanted.above || wanted.below) {
    const double largest = LargestOf(recording_, name, wanted.field);
    if (wanted.above && !(largest > *wanted.above)) return false;
    if (wanted.below && largest >= *wanted.below) return false;
  }
  if (!wanted.outputs.empty()) {
    std::vector<std::string> fields;
    for (int i = 0; i < kMostCounted; ++i) fields.push_back(WithNumber(wanted.outputs, i));
    found->num_outputs = NumThatReach(recording_, name, fields, wanted.reach);
    return wanted.is_idle_too || found->num_outputs > 0;
  }
  if (!wanted.motors.empty()) {
    std::vector<std::string> channels = {name};
    for (const std::string& type : wanted.also) {
      channels.push_back(FirstChannelOf(recording_.contents(), type));
    }
    found->motors = MotorOutputsOf(recording_, channels, wanted.motors);
    found->num_outputs = static_cast<int>(found->motors.motors.size());
  }
  return true;
}

}  // namespace fathom
