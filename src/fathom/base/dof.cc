// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/dof.h"

#include "fathom/base/input_error.h"

namespace fathom {
namespace {

struct DofNames {
  std::string_view name;
  std::string_view velocity;
  std::string_view force;
};

constexpr std::array<DofNames, 6> kNames = {{{"surge", "u", "tau_surge"},
                                             {"sway", "v", "tau_sway"},
                                             {"heave", "w", "tau_heave"},
                                             {"roll", "p", "tau_roll"},
                                             {"pitch", "q", "tau_pitch"},
                                             {"yaw", "r", "tau_yaw"}}};

}  // namespace

std::string_view Name(Dof dof) { return kNames[Index(dof)].name; }

std::string_view VelocityColumn(Dof dof) { return kNames[Index(dof)].velocity; }

std::string_view ForceColumn(Dof dof) { return kNames[Index(dof)].force; }

std::string_view DisplacementUnit(Dof dof) { return IsAngular(dof) ? "rad" : "m"; }

std::string_view VelocityUnit(Dof dof) { return IsAngular(dof) ? "rad/s" : "m/s"; }

std::string_view ForceUnit(Dof dof) { return IsAngular(dof) ? "N m" : "N"; }

std::optional<Dof> DofFromName(std::string_view name) {
  for (const Dof dof : kAllDofs) {
    if (Name(dof) == name) return dof;
  }
  return std::nullopt;
}

Dof ParseDof(const std::string& name) {
  if (const auto dof = DofFromName(name)) return *dof;
  throw InputError("is '" + name + "', expected surge, sway, heave, roll, pitch or yaw.");
}

}  // namespace fathom
