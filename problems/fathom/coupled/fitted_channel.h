// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/simulate/coupled/coupled_data.h"

#include <span>
#include <vector>

namespace fathom {

// One measured quantity that a fit compares the simulation with.
struct FittedChannel {
  enum class Kind {
    kVelocity,  // of velocity.csv, along `row`
    kTurn,      // of the attitude: a small turn about the body's axis of the DOF `row` [rad]
    kPosition,  // in the world, along x, y, z for `row` 0, 1, 2 [m]
  };
  Kind kind = Kind::kVelocity;
  int row = 0;

  bool operator==(const FittedChannel&) const = default;
};

// What a fit of these logs takes: the velocities of the modelled DOFs; the attitude of roll and
// pitch, which their righting moments need, and of yaw where no rate is measured; the positions
// where a linear velocity is not.
std::vector<FittedChannel> ChannelsOf(std::span<const CoupledData> logs);

}  // namespace fathom
