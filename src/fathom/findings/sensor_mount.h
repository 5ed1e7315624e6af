// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/log.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace fathom {

// A linear column of velocity.csv, and how much later it comes than the poses [s].
struct LateColumn {
  Dof dof = Dof::kSurge;
  double delay = 0.0;
};

// A number and its 95 % interval; NaN where it is not known.
struct MountEstimate {
  double value = std::numeric_limits<double>::quiet_NaN();
  double half_width = std::numeric_limits<double>::quiet_NaN();

  // Whether it is over `least`, either way, and its interval leaves out 0.
  bool IsOver(double least) const {
    return std::abs(value) > least && std::abs(value) > half_width;
  }
};

// Where the sensor of velocity.csv's linear columns sits, seen from the point and the axes that
// pose.csv is of; docs/findings.md (12).
struct SensorMount {
  std::array<MountEstimate, 3> arm;  // x y z in the axes of the vehicle [m]
  MountEstimate angle;               // about z, to starboard [rad]

  // Whether it takes away a fifth of what the two motions do not share; the angle only if it is
  // over 3 degrees.
  bool needs_arm = false, needs_angle = false;

  // What (12) leaves of the squares of u, v, w about their means; NaN of a column that is not
  // there.
  std::array<double, 3> missed = {std::numeric_limits<double>::quiet_NaN(),
                                  std::numeric_limits<double>::quiet_NaN(),
                                  std::numeric_limits<double>::quiet_NaN()};

  // Of what a column shows: one of which (12) leaves less is one motion with the poses, as by a
  // correlation of 0.8.
  static constexpr double kMostMissed = 0.36;

  bool Explains(Dof dof) const { return !IsAngular(dof) && missed[Index(dof)] < kMostMissed; }
};

// The rates are those of the poses; arms along which no rate over 0.05 rad/s (standard deviation)
// acts are not known. Nothing where the two motions are not one, and of less than 30 windows of
// the filter.
std::optional<SensorMount> SensorMountOf(const Log& log, const std::vector<LateColumn>& columns);

}  // namespace fathom
