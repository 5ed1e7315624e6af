// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/thruster_text.h"

#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

constexpr double kNoMoment = 1e-9;  // for a force of 1 [m] or [1]

}  // namespace

std::vector<std::string> UseOfThrusters(const PlannedThrusts& plan,
                                        const ThrusterSet& thrusters,
                                        const std::string& vehicle) {
  double hardest = 0.0;
  std::string name;
  std::vector<std::string> unknown;
  for (std::size_t k = 0; k < thrusters.names.size(); ++k) {
    const ValueRange range = thrusters.range[k];
    if (std::isinf(range.low) || std::isinf(range.high)) unknown.push_back(thrusters.names[k]);
    for (const std::vector<double>& row : plan.thrust) {
      const double end = row[k] < 0.0 ? range.low : range.high;
      const double share = row[k] == 0.0 ? 0.0 : row[k] / end;
      if (share <= hardest) continue;
      hardest = share;
      name = thrusters.names[k];
    }
  }
  std::vector<std::string> comments;
  if (hardest > 0.0) {
    comments.push_back(
        fmt::format("The plan takes at most {:.0f} % of what a thruster gives (`{}`){}.",
                    100.0 * hardest,
                    name,
                    std::isnan(thrusters.voltage) ? std::string()
                                                  : fmt::format(", at {:g} V", thrusters.voltage)));
  }
  if (!unknown.empty()) {
    comments.push_back(
        fmt::format("{} does not say how much {} can give: set thruster_force in the limits file.",
                    vehicle,
                    fmt::join(unknown, ", ")));
  }
  return comments;
}

std::vector<std::string> MomentsToRight(Dof dof, const ThrusterAllocation& allocation) {
  std::vector<std::string> comments;
  for (const auto& [moment, other] :
       {std::pair{allocation.roll, Dof::kRoll}, std::pair{allocation.pitch, Dof::kPitch}}) {
    if (std::abs(moment) < kNoMoment) continue;
    comments.push_back(fmt::format(
        "The thrusters cannot but give {} {:.3g} N m for each {} of {} too: the vehicle "
        "has to right itself.",
        Name(other),
        moment,
        ForceUnit(dof),
        Name(dof)));
  }
  return comments;
}

}  // namespace fathom
