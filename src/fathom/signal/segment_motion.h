// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/held_command.h"
#include "fathom/log/log.h"
#include "fathom/signal/filters/savitzky_golay.h"
#include "fathom/signal/pose_velocity.h"
#include "fathom/signal/segment.h"

#include <cstddef>
#include <vector>

namespace fathom {

// The motion of one DOF over one unbroken stretch.
struct Motion {
  std::vector<double> time;
  std::vector<double> velocity;
  std::vector<double> position;  // empty without poses, and where the DOF's axis turns
  std::vector<double> force;     // the command's first integral through the poses' filter; empty
                                 // without poses
  std::vector<bool> is_centred;  // false: the velocity itself comes from a one-sided window
};

// Rows `begin` to `end` - 1 of the velocity stream.
Motion MotionFromVelocity(const Stream& stream, Dof dof, size_t begin, size_t end);

// Velocity from poses, and the command's impulse through the same filter. `position` is the
// displacement along the DOF; empty where its axis turns. Stamps at which the filter fails are left
// out.
Motion MotionFromPoses(const Poses& poses,
                       Dof dof,
                       const std::vector<double>& position,
                       const HeldCommand& command,
                       const SavitzkyGolayOptions& filter);

// The segment with the columns of docs/signal.md (3).
Segment SegmentOf(Motion motion, HeldCommand command, const SavitzkyGolayOptions& filter);

}  // namespace fathom
