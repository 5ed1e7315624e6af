// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/run_start.h"

#include "fathom/signal/pose_velocity.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fathom {

double InitialVelocity(const Segment& segment) {
  return std::isfinite(segment.initial_velocity) ? segment.initial_velocity
                                                 : segment.velocity.front();
}

Line LineThrough(double start, std::span<const double> time, std::span<const double> value) {
  double n = 0.0, st = 0.0, sy = 0.0, stt = 0.0, sty = 0.0;
  for (std::size_t i = 0; i < time.size(); ++i) {
    const double t = time[i] - start;
    n += 1.0;
    st += t;
    sy += value[i];
    stt += t * t;
    sty += t * value[i];
  }
  const double slope = (n * sty - st * sy) / std::max(1e-12, n * stt - st * st);
  return {(sy - slope * st) / n, slope};
}

double PositionAt(const Log& log, Dof dof, double time) {
  if (!log.pose || !TellsMotion(*log.pose, dof)) return 0.0;
  const Poses poses = PosesOf(*log.pose);
  const std::vector<double> position = DisplacementAlong(dof, poses);
  const auto next = std::lower_bound(poses.time.begin(), poses.time.end(), time);
  if (next == poses.time.begin()) return position.front();
  if (next == poses.time.end()) return position.back();
  const auto i = static_cast<std::size_t>(next - poses.time.begin());
  const double share = (time - poses.time[i - 1]) / (poses.time[i] - poses.time[i - 1]);
  return position[i - 1] + share * (position[i] - position[i - 1]);
}

std::vector<double> WayAlong(std::span<const double> time,
                             std::span<const double> velocity,
                             std::size_t first) {
  std::vector<double> way(time.size(), 0.0);
  for (std::size_t i = first + 1; i < time.size(); ++i) {
    way[i] = way[i - 1] + 0.5 * (time[i] - time[i - 1]) * (velocity[i - 1] + velocity[i]);
  }
  return way;
}

}  // namespace fathom
