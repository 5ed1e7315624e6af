// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/adaptive/pass.h"

#include "fathom/signal/filters/integral.h"
#include "fathom/simulate/run_start.h"

#include <algorithm>

namespace fathom {
namespace {

// Mean of the held command between each two stamps, and what holds at the last one. A command that
// does not change in between is its own mean to the last digit: a log whose streams share their
// stamps then gives what AdaptiveFollower makes of its samples.
std::vector<double> MeanForces(const HeldCommand& command, const std::vector<double>& time) {
  const std::vector<double> impulse = IntegralsOf(command, time).once;
  std::vector<double> force = command.At(time);
  auto change = command.time.begin();
  for (size_t i = 0; i + 1 < time.size(); ++i) {
    change = std::upper_bound(change, command.time.end(), time[i]);
    if (change == command.time.end() || *change >= time[i + 1]) continue;
    force[i] = (impulse[i + 1] - impulse[i]) / (time[i + 1] - time[i]);
  }
  return force;
}

}  // namespace

std::vector<PassSegment> PassOver(std::span<const Segment> segments) {
  std::vector<PassSegment> pass;
  for (const Segment& segment : segments) {
    if (segment.time.empty()) continue;
    std::vector<double> force = MeanForces(segment.command, segment.time);
    pass.push_back({segment.time, std::move(force), segment.velocity, InitialVelocity(segment)});
  }
  std::sort(pass.begin(), pass.end(), [](const PassSegment& a, const PassSegment& b) {
    return a.time.front() < b.time.front();
  });
  return pass;
}

}  // namespace fathom
