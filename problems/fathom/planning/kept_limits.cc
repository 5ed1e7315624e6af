// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/kept_limits.h"

#include <algorithm>
#include <cmath>

namespace fathom {

bool KeepsLimits(const PlannedMotion& motion, const PlanLimits& limits) {
  const bool is_slow =
      std::all_of(motion.velocity.begin(), motion.velocity.end(), [&](double velocity) {
        return std::abs(velocity) <= limits.speed;
      });
  return is_slow &&
         std::all_of(
             motion.displacement.begin(), motion.displacement.end(), [&](double displacement) {
               return displacement >= limits.distance.low && displacement <= limits.distance.high;
             });
}

double UsableForce(const ExtendedModel& model, Dof dof, const PlanLimits& limits) {
  constexpr int kMostHalvings = 40;
  constexpr double kPeriod = 0.1;  // [s]
  const std::vector<double> stamps =
      LimitStamps(limits.shortest_hold, limits.shortest_hold + kCoastAfterwards, kPeriod);
  double force = limits.force;
  for (int i = 0; i < kMostHalvings; ++i, force *= 0.5) {
    const auto keeps = [&](double sign) {
      const HeldCommand hold = {{0.0, limits.shortest_hold}, {sign * force, 0.0}};
      const auto motion = MotionUnder(model, dof, hold, stamps);
      return motion && KeepsLimits(*motion, limits);
    };
    if (keeps(1.0) || keeps(-1.0)) break;
  }
  return force;
}

int NumBreaking(std::span<const ExtendedModel> models,
                Dof dof,
                const HeldCommand& command,
                std::span<const double> stamps,
                const PlanLimits& limits,
                int most) {
  int num_breaking = 0;
  for (const ExtendedModel& model : models) {
    const auto motion = MotionUnder(model, dof, command, stamps);
    if (!motion || !KeepsLimits(*motion, limits)) ++num_breaking;
    if (num_breaking > most) break;
  }
  return num_breaking;
}

}  // namespace fathom
