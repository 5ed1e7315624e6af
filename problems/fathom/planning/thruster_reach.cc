// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/thruster_reach.h"

#include "fathom/base/input_error.h"

#include <cmath>

#include <fmt/format.h>

namespace fathom {

void RequireNoThrusterForce(const std::string& limits_name, double thruster_force) {
  if (!std::isfinite(thruster_force)) return;
  throw InputError(fmt::format(
      "{}: key 'thruster_force' goes with --vehicle, expected none without it.", limits_name));
}

void RequireBothWays(Dof dof, const ThrusterAllocation& allocation, const std::string& vehicle) {
  if (allocation.ReachEachWay() > 0.0) return;
  throw InputError(fmt::format("{}: its thrusters give {} {:.4g} to {:.4g} {}, expected both ways.",
                               vehicle,
                               Name(dof),
                               allocation.reach.low,
                               allocation.reach.high,
                               ForceUnit(dof)));
}

void RequireWithinReach(const ForceLimit& limit,
                        Dof dof,
                        const ThrusterAllocation& allocation,
                        const std::string& vehicle) {
  const double most = allocation.ReachEachWay();
  if (limit.force <= most) return;
  throw InputError(
      fmt::format("{}: key '{}' is {:g} {}, expected at most {:.6g}: the thrusters of {} give {} "
                  "{:.4g} to {:.4g} {}.",
                  limit.file,
                  limit.key,
                  limit.force,
                  ForceUnit(dof),
                  most * (1.0 - 1e-5),  // six digits of it are not more than `most`
                  vehicle,
                  Name(dof),
                  allocation.reach.low,
                  allocation.reach.high,
                  ForceUnit(dof)));
}

}  // namespace fathom
