// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/flown_entries.h"

#include "fathom/base/input_error.h"
#include "fathom/coupled/window_search.h"
#include "fathom/coupled_planning/coupled_noise.h"

#include <cstddef>
#include <limits>

#include <fmt/format.h>

namespace fathom {
namespace {

// A plan counts velocities alone, and so do the logs beside it.
std::vector<FittedChannel> VelocitiesOf(const CoupledData& log) {
  std::vector<FittedChannel> channels = ChannelsOf({&log, 1});
  std::erase_if(channels, [](const FittedChannel& channel) {
    return channel.kind != FittedChannel::Kind::kVelocity;
  });
  if (channels.empty()) {
    throw InputError(fmt::format(
        "--log: {} measures no velocity of a DOF of the model, expected one at the least.",
        log.log));
  }
  return channels;
}

}  // namespace

Eigen::MatrixXd FlownInformation(const CoupledPlanRequest& request,
                                 const CoupledPlan& plan,
                                 const std::vector<FreeEntry>& entries) {
  const auto size = static_cast<Eigen::Index>(entries.size());
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(size, size);
  WindowSearchOptions no_step;
  no_step.max_iterations = 0;
  for (CoupledData log : request.flown) {
    for (CoupledSegment& segment : log.segments) segment.is_held_out = false;
    WindowProblem problem;
    problem.windows = CoupledWindowsOf({&log, 1}, WindowOf(request));
    problem.entries = entries;
    problem.channels = VelocitiesOf(log);
    problem.free = FreeStartOf({&log, 1}, problem.channels);
    WindowPoint point = {request.model.model, {}};
    for (const CoupledWindow& window : problem.windows) point.starts.push_back(window.start);
    std::vector<ChannelWeight> weights;
    for (const FittedChannel& channel : problem.channels) {
      weights.push_back({RowWhitener(NoiseOfSample(
                             request, plan, kAllDofs[static_cast<std::size_t>(channel.row)])),
                         /*huber_k=*/std::numeric_limits<double>::infinity()});
    }
    const WindowSearch at = SearchWindows(problem, weights, point, no_step);
    if (at.near.num_rows == 0) {
      throw InputError(
          fmt::format("--log: {} diverges over {}, expected a model of the same vehicle.",
                      request.name,
                      log.log));
    }
    sum += at.near.normal;
  }
  return sum;
}

}  // namespace fathom
