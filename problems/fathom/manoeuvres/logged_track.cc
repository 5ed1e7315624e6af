// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/manoeuvres/logged_track.h"

#include "fathom/base/dof.h"
#include "fathom/simulate/coupled/attitude_angles.h"

#include <algorithm>

namespace fathom {
namespace {

double AngleAt(const std::vector<double>& time, const std::vector<double>& angle, double t) {
  const auto next = std::ranges::upper_bound(time, t);
  if (next == time.end()) return angle.back();
  const auto k = static_cast<std::size_t>(next - time.begin());
  const double share = (t - time[k - 1]) / (time[k] - time[k - 1]);
  return (1.0 - share) * angle[k - 1] + share * angle[k];
}

}  // namespace

std::optional<ManoeuvreTrack> LoggedTrack(const CoupledData& data, std::size_t fin) {
  const CoupledCommand& command = data.inputs.command;
  if (!data.has_attitude || data.segments.empty() || command.time.empty()) return std::nullopt;
  const CoupledSegment& segment =
      *std::ranges::max_element(data.segments, {}, [](const CoupledSegment& candidate) {
        return candidate.time.back() - candidate.time.front();
      });
  ManoeuvreTrack track;
  track.fin_sign = command.fins[fin].arms.across[Index(Dof::kYaw)] < 0.0 ? -1.0 : 1.0;
  double heading = 0.0;
  for (std::size_t k = 0; k < segment.time.size(); ++k) {
    const double t = segment.time[k];
    if (t < command.time.front() || t > command.time.back()) continue;
    track.time.push_back(t);
    track.state.push_back(MeasuredState(segment, k));
    heading = UnwrappedHeading(track.state.back(), heading);
    track.heading.push_back(heading);
    track.angle.push_back(AngleAt(command.time, command.fins[fin].angle, t));
  }
  if (track.time.empty()) return std::nullopt;
  return track;
}

}  // namespace fathom
