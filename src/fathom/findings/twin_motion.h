// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/log.h"
#include "fathom/signal/filters/savitzky_golay.h"

#include <limits>
#include <span>
#include <string>
#include <vector>

namespace fathom {

// The motion along one DOF as a log holds it twice: a column of velocity.csv, and the velocity that
// the poses give, both smoothed over one second (or six steps).
struct TwinMotion {
  Dof dof = Dof::kSurge;
  std::string column;              // of velocity.csv
  std::vector<double> pose_time;   // [s]
  std::vector<double> from_pose;   // [m/s] or [rad/s]; NaN near the ends
  std::vector<double> in_world;    // the same along the world's axis of this name [m/s]; empty for
                                   // an angular DOF
  std::vector<double> twist_time;  // [s]
  std::vector<double> twist;       // [m/s] or [rad/s]

  double window = 0.0;  // of the smoothing [s]

  double SlowestStep() const;  // the larger of the two median steps [s]
};

// The filter that both are smoothed by. The log has both, of 50 samples or more.
SavitzkyGolayOptions TwinFilter(const Log& log);

// A column of velocity.csv, smoothed as the poses are, so that fast motion and noise count alike in
// both.
std::vector<double> SmoothTwist(std::span<const double> time,
                                std::span<const double> twist,
                                const SavitzkyGolayOptions& filter);

// Of those DOFs along which both move: by over 0.02 m/s or 0.01 rad/s (standard deviation). Empty
// for a log that lacks one of the two, or has under 50 samples of it.
std::vector<TwinMotion> TwinMotionsOf(const Log& log);

// The standard deviation of those values that are known; 0 of fewer than two.
double SpreadOf(std::span<const double> values);

// What the two share. Too few samples: the correlation is 0, the others NaN.
struct Likeness {
  double correlation = 0.0;
  double gain = std::numeric_limits<double>::quiet_NaN();  // of the twist over the pose's velocity,
                                                           // both about their means
  double size = std::numeric_limits<double>::quiet_NaN();  // of their root mean squares
};

// The twist `delay` [s] after the stamps of the poses; NaN beyond its ends.
std::vector<double> AtPoses(const TwinMotion& motion, double delay = 0.0);

// The value of a curve at a time, on straight lines; NaN beyond its ends, and between two stamps
// that are further apart than this.
double ValueAt(std::span<const double> time,
               std::span<const double> values,
               double t,
               double longest_step = std::numeric_limits<double>::infinity());

// The sum of the twist's squares at the stamps of the poses, and of its difference from another
// curve there, where both are known.
struct Misfit {
  double twist = 0.0, difference = 0.0;
};
Misfit MisfitTo(const std::vector<double>& at_poses, const TwinMotion& motion);

// Of the pose's velocity at its stamps and the twist `delay` [s] later.
Likeness LikenessAt(double delay, const TwinMotion& motion);

}  // namespace fathom
