// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"
#include "fathom/import/suggest/motor_outputs.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// One way to recognise a channel of two samples or more: docs/import.md, "Maps with conditions".
struct WantedChannel {
  std::string name, type;       // where not empty; a type without ROS's "msg/" and Rock's "_m"
  std::string field;            // that it has; empty: any
  std::optional<double> above;  // `field` is above it once at least
  std::optional<double> below;  // and never reaches this one

  // Of outputs, '#' for their number: "control[#]" from 0 on, those that ever reach a value, of
  // which there must be one; or "C#" from 1 on, which ArduPilot's settings give to motors, those
  // behind them in channels of the types `also`.
  std::string outputs, motors;
  double reach = 0.0;
  bool is_idle_too = false;  // none of `outputs` need reach it for a vehicle that is known
  std::vector<std::string> also;

  std::string text;  // that the map says of it
};

struct FoundChannel {
  const Channel* channel = nullptr;  // null: there is none
  const WantedChannel* wanted = nullptr;
  std::size_t num_others = 0;  // channels of any of the ways that were not taken
  int num_outputs = 0;
  MotorOutputs motors;
};

// The ways to recognise a channel, the surest first, by what a map calls it.
using WantedChannels = std::map<std::string, std::vector<WantedChannel>, std::less<>>;

// The channels that a map looks for. Each is looked for when it is first asked for.
class FoundChannels {
 public:
  // Of several that fit, that with the most samples is taken, or the first. All outlive this.
  FoundChannels(const Recording& recording, const WantedChannels& wanted, bool takes_most);

  // Of none that is looked for: not found.
  const FoundChannel& Of(std::string_view name);

 private:
  FoundChannel Find(const std::vector<WantedChannel>& ways) const;
  bool MeetsItsNumbers(FoundChannel* found) const;

  const Recording& recording_;
  const WantedChannels& wanted_;
  bool takes_most_;
  std::map<std::string, FoundChannel, std::less<>> found_;
};

}  // namespace fathom
