// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/data/log_channels.h"

#include "fathom/base/input_error.h"
#include "fathom/diagnosis/data/pose_coordinate.h"
#include "fathom/log/remark.h"
#include "fathom/signal/sources/log_column.h"

#include <algorithm>

#include <fmt/format.h>

namespace fathom {
namespace {

// Throws InputError if nothing is.
LogChannels ChannelsOf(const Log& log, const std::string& name, Dof dof) {
  LogChannels channels = {&log, name, std::nullopt, std::nullopt, {}};
  if (log.velocity) {
    if (const auto* column = log.velocity->Find(VelocityColumn(dof))) {
      channels.velocity = SampledSignal{log.velocity->time, *column};
    }
  }
  channels.displacement = PoseCoordinate(log, name, dof, &channels.remarks);
  if (!channels.velocity && !channels.displacement) {
    const bool has_poses_alone = log.pose && !log.velocity;
    MotionStream(log, dof, has_poses_alone ? Source::kCamera : Source::kPoseEstimator);
    throw InputError(channels.remarks.back());
  }
  return channels;
}

}  // namespace

std::vector<LogChannels> ChannelsOf(std::span<const Log> logs,
                                    const std::vector<std::string>& names,
                                    Dof dof) {
  std::vector<LogChannels> channels;
  const std::string first_unit = CommandUnitOf(logs.front(), dof);
  for (size_t k = 0; k < logs.size(); ++k) {
    if (const std::string unit = CommandUnitOf(logs[k], dof); unit != first_unit) {
      throw InputError(
          fmt::format("{}: its commands are in {}, those of {} in {}: expected logs of one unit.",
                      names[k],
                      unit,
                      names.front(),
                      first_unit));
    }
    channels.push_back(ChannelsOf(logs[k], names[k], dof));
  }
  return channels;
}

bool LosesMotion(const LogChannels& channels) {
  return channels.displacement && Holds(channels.log->remarks, RemarkKind::kLostMotion);
}

}  // namespace fathom
