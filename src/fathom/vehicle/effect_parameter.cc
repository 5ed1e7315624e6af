// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/effect_parameter.h"

namespace fathom {

std::string UnitOf(const Quantity& quantity, Dof dof, const std::string& force_unit) {
  std::string unit(IsAngular(dof) ? quantity.angular_unit : quantity.linear_unit);
  if (force_unit == ForceUnit(dof)) return unit;
  // A force of another unit: kilograms are then not kilograms. Built from its powers.
  if (quantity.force == 0.0) return unit;
  const std::string distance = std::string(DisplacementUnit(dof));
  const auto factor = [](const std::string& of, double power) {
    const int whole = static_cast<int>(power);
    return power == 0.0 ? "" : power == 1.0 ? of : of + "^" + std::to_string(whole);
  };
  std::string text = quantity.force == 0.5 ? "sqrt(" + force_unit + ")" : force_unit;
  const double seconds = quantity.time - quantity.speed;
  if (seconds > 0.0) text += " " + factor("s", seconds);
  const std::string below = factor(distance, -quantity.speed);
  const std::string below_seconds = seconds < 0.0 ? factor("s", -seconds) : "";
  if (!below.empty()) text += "/" + below;
  if (!below_seconds.empty()) text += "/" + below_seconds;
  return text;
}

}  // namespace fathom
