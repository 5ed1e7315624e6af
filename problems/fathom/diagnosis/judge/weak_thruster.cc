// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/judge/weak_thruster.h"

#include "fathom/vehicle/effects/catalogue.h"

#include <cmath>

namespace fathom {
namespace {

constexpr double kNoPush = 1e-6;  // [N or N m] of a thrust of 1 N
constexpr double kBeyondDead = 0.05;

}  // namespace

std::optional<WeakThruster> WeakThrusterOf(const ActiveEffect& active,
                                           double std,
                                           std::span<const Thruster> thrusters) {
  if (active.effect != FindEffect("thrust_crosstalk")) return std::nullopt;
  const auto allocation = AllocationMatrix({thrusters.begin(), thrusters.end()});
  const int own = Index(active.setting.dof), partner = Index(active.setting.partner);
  Eigen::Index only = -1;
  for (Eigen::Index k = 0; k < allocation.cols(); ++k) {
    if (std::abs(allocation(partner, k)) < kNoPush) continue;
    if (only >= 0) return std::nullopt;  // which of several is open
    only = k;
  }
  if (only < 0 || std::abs(allocation(own, only)) < kNoPush) return std::nullopt;
  const double ratio = allocation(partner, only) / allocation(own, only);
  const double change = active.values.front() * ratio;
  if (!(change < 0.0 && change > -1.0 - kBeyondDead)) return std::nullopt;
  return WeakThruster{
      thrusters[static_cast<std::size_t>(only)].name, change, std * std::abs(ratio)};
}

}  // namespace fathom
