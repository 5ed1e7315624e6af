// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/fitted_channel.h"

#include <algorithm>
#include <cstddef>

namespace fathom {

std::vector<FittedChannel> ChannelsOf(std::span<const CoupledData> logs) {
  std::vector<FittedChannel> channels;
  bool lacks_linear = false;
  const auto has_velocity = [&](Dof dof) {
    return std::all_of(logs.begin(), logs.end(), [&](const CoupledData& log) {
      return log.has_velocity[static_cast<std::size_t>(Index(dof))];
    });
  };
  const bool has_attitude = std::all_of(
      logs.begin(), logs.end(), [](const CoupledData& log) { return log.has_attitude; });
  for (const Dof dof : logs.front().dofs) {
    const bool has_rate = has_velocity(dof);
    if (has_rate) channels.push_back({FittedChannel::Kind::kVelocity, Index(dof)});
    lacks_linear = lacks_linear || (!has_rate && !IsAngular(dof));
    if (!IsAngular(dof) || !has_attitude) continue;
    if (dof != Dof::kYaw || !has_rate) channels.push_back({FittedChannel::Kind::kTurn, Index(dof)});
  }
  if (!lacks_linear) return channels;
  for (int axis = 0; axis < 3; ++axis) {
    const bool is_known = std::all_of(logs.begin(), logs.end(), [&](const CoupledData& log) {
      return log.has_position[static_cast<std::size_t>(axis)];
    });
    if (is_known) channels.push_back({FittedChannel::Kind::kPosition, axis});
  }
  return channels;
}

}  // namespace fathom
