// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"

#include <span>

#include <Eigen/Geometry>

namespace fathom {

// The attitude that a vehicle driven along `dof` keeps, out of world_from_body at many times, one
// at least: the axis of the DOF is the middle one of that body axis, and the others are as near to
// theirs as that allows, or where they turn all the way round, to the first. The middle is by the
// median of each coordinate, so that the flips of a single square do not pull it along. One of the
// world's axes that is as near as 0.005 rad is taken instead: a motion along it is as long to 1e-5,
// and what the vehicle does along the others does not leak in by the noise of the attitudes.
Eigen::Quaterniond MeanAttitude(Dof dof, std::span<const Eigen::Quaterniond> world_from_body);

// A body axis that turns by more than this is not that of one displacement any more [rad, RMS].
inline constexpr double kLargestAxisTurn = 0.12;

// How far the body axis of `dof` turns about that of MeanAttitude() [rad, RMS].
double AxisTurn(Dof dof, std::span<const Eigen::Quaterniond> world_from_body);

}  // namespace fathom
