// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/log.h"
#include "fathom/signal/filters/savitzky_golay.h"

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace fathom {

// world_from_body at every stamp.
struct Poses {
  std::vector<double> time;                         // [s], strictly increasing
  std::vector<Eigen::Vector3d> position;            // of the body's origin in the world [m]
  std::vector<Eigen::Quaterniond> world_from_body;  // length 1, neighbours in one hemisphere

  size_t size() const { return time.size(); }
  Poses Between(size_t begin, size_t end) const;
};

// Whether a pose stream tells the motion in a DOF. Turns take an attitude, heave takes z: without x
// and y it is the vertical motion, and without an attitude the vehicle's that stays level.
bool TellsMotion(const Stream& pose, Dof dof);

// The poses of a stream with some of the columns x y z qx qy qz qw. What it does not hold is 0 and
// no turn: ask TellsMotion() which DOFs they mean anything in.
Poses PosesOf(const Stream& pose);

// The velocity of a body from its poses; docs/signal.md (5) to (7).
//
//   v = R' dp/dt                 local polynomial of the position
//   omega = J_r(phi) dphi/dt     local polynomial of phi_j = log(R_i' R_j) about each stamp i
//
// R at the stamp is the smoothed one, R_i exp(phi(t_i)). No angle is differenced, so nothing is
// singular. Windows must span less than half a turn.
struct BodyVelocity {
  std::vector<Eigen::Vector<double, 6>> velocity;  // u v w p q r; NaN where the fit fails
  std::vector<bool> is_centred;                    // false: window shifted, noise several times
};

BodyVelocity VelocityOf(const Poses& poses, const SavitzkyGolayOptions& options);

// The displacement along a DOF, growing with a positive velocity in it, by MeanAttitude(). Of
// surge, sway and heave [m]: the position's component along the mean body axis. Of yaw [rad]: the
// angle about the mean body axis, from the first heading on. Of roll and pitch, and of yaw where
// its axis turns by more than kLargestAxisTurn [rad]: that of yaw-pitch-roll. Angles are unwrapped.
std::vector<double> DisplacementAlong(Dof dof, const Poses& poses);

// Number of steps between neighbouring rotations that are over 5 degrees and over 6 times as large
// as the median step of the 20 around: how often the pose of a single square changed from one of
// its two solutions to the other.
int CountRotationFlips(const Poses& poses);

}  // namespace fathom
