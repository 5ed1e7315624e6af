// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/effect_info.h"

namespace fathom {

std::string_view Name(Place place) {
  switch (place) {
    case Place::kActuator:
      return "actuator";
    case Place::kWater:
      return "water";
    case Place::kSensor:
      return "sensor";
  }
  return "";
}

bool CanActAlong(const EffectInfo& info, Dof dof) {
  return info.acts_along == nullptr || info.acts_along(dof);
}

bool CanBePartner(const EffectInfo& info, Dof dof, Dof partner) {
  if (!info.partner || partner == dof) return false;
  return info.partner->rule == nullptr || info.partner->rule(dof, partner);
}

}  // namespace fathom
