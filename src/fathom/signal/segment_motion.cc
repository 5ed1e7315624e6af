// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/segment_motion.h"

#include "fathom/signal/filters/integral.h"
#include "fathom/signal/filters/moving_fit.h"

#include <cmath>
#include <limits>
#include <utility>

namespace fathom {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Integral of v|v|, where v is smoothed first, lest its noise counts as speed. With poses v|v|
// passes the poses' filter too, as the force does.
std::vector<double> IntegralOfSquare(const Motion& motion, const SavitzkyGolayOptions& filter) {
  std::vector<double> square = SavitzkyGolay(motion.time, motion.velocity, 0, filter);
  for (size_t i = 0; i < square.size(); ++i) {
    if (std::isnan(square[i])) square[i] = motion.velocity[i];
    square[i] *= std::abs(square[i]);
  }
  std::vector<double> integral = Integral(motion.time, square);
  if (motion.force.empty()) return integral;
  std::vector<double> filtered = SavitzkyGolay(motion.time, integral, 1, filter);
  for (size_t i = 0; i < square.size(); ++i) {
    if (std::isnan(filtered[i])) filtered[i] = square[i];
  }
  return Integral(motion.time, filtered);
}

}  // namespace

Motion MotionFromVelocity(const Stream& stream, Dof dof, size_t begin, size_t end) {
  const auto cut = [&](const std::vector<double>& all) {
    return std::vector<double>(all.begin() + static_cast<std::ptrdiff_t>(begin),
                               all.begin() + static_cast<std::ptrdiff_t>(end));
  };
  Motion motion;
  motion.time = cut(stream.time);
  motion.velocity = cut(*stream.Find(VelocityColumn(dof)));
  motion.is_centred.assign(motion.time.size(), true);
  return motion;
}

Motion MotionFromPoses(const Poses& poses,
                       Dof dof,
                       const std::vector<double>& position,
                       const HeldCommand& command,
                       const SavitzkyGolayOptions& filter) {
  const BodyVelocity body = VelocityOf(poses, filter);
  const std::vector<double> impulse =
      SavitzkyGolay(poses.time, IntegralsOf(command, poses.time).twice, 1, filter);
  Motion motion;
  for (size_t i = 0; i < poses.size(); ++i) {
    const double velocity = body.velocity[i][Index(dof)];
    if (!std::isfinite(velocity)) continue;
    motion.time.push_back(poses.time[i]);
    motion.velocity.push_back(velocity);
    if (!position.empty()) motion.position.push_back(position[i]);
    motion.force.push_back(impulse[i]);
    motion.is_centred.push_back(body.is_centred[i]);
  }
  return motion;
}

Segment SegmentOf(Motion motion, HeldCommand command, const SavitzkyGolayOptions& filter) {
  // docs/signal.md (3): derivatives of velocity, displacement and impulse by one and the same
  // filter.
  const std::vector<double> displacement = Integral(motion.time, motion.velocity);
  const std::vector<double> square = IntegralOfSquare(motion, filter);
  const std::vector<double> impulse =
      motion.force.empty() ? IntegralsOf(command, motion.time).once : motion.force;
  const size_t n = motion.time.size();
  Segment segment;
  segment.acceleration.assign(n, kNaN);
  segment.smoothed_velocity.assign(n, kNaN);
  segment.smoothed_force.assign(n, kNaN);
  segment.smoothed_square.assign(n, kNaN);
  MovingFit fit(motion.time, {motion.velocity, displacement, impulse, square}, filter);
  if (fit.MoveTo(0, 0)) segment.initial_velocity = fit.Estimate(0);
  size_t num_seen = 0, past_one_sided = 0;  // samples; the last of them from a one-sided window
  for (size_t i = 0; i < n; ++i) {
    const bool is_fitted = fit.MoveTo(i, 1);
    const MovingWindow& window = fit.window();
    for (; num_seen < window.past_last(); ++num_seen) {
      if (!motion.is_centred[num_seen]) past_one_sided = num_seen + 1;
    }
    if (!is_fitted || !window.is_centred() || past_one_sided > window.first()) continue;
    segment.acceleration[i] = fit.Estimate(0);
    segment.smoothed_velocity[i] = fit.Estimate(1);
    segment.smoothed_force[i] = fit.Estimate(2);
    segment.smoothed_square[i] = fit.Estimate(3);
  }
  segment.time = std::move(motion.time);
  segment.velocity = std::move(motion.velocity);
  segment.position = std::move(motion.position);
  segment.command = std::move(command);
  return segment;
}

}  // namespace fathom
