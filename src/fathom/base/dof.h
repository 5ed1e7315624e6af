// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace fathom {

// The six degrees of freedom of a rigid body, with SNAME's letters; docs/notation.md.
enum class Dof { kSurge, kSway, kHeave, kRoll, kPitch, kYaw };

inline constexpr std::array<Dof, 6> kAllDofs = {
    Dof::kSurge, Dof::kSway, Dof::kHeave, Dof::kRoll, Dof::kPitch, Dof::kYaw};

// 0 for surge to 5 for yaw.
constexpr int Index(Dof dof) { return static_cast<int>(dof); }

// True for roll, pitch and yaw: rad/s and N m instead of m/s and N.
constexpr bool IsAngular(Dof dof) { return Index(dof) >= 3; }

// "surge", "sway", ...
std::string_view Name(Dof dof);

// Name of the velocity in velocity.csv: "u", "v", "w", "p", "q", "r".
std::string_view VelocityColumn(Dof dof);

// Name of the generalised force in command.csv: "tau_surge", ...
std::string_view ForceColumn(Dof dof);

// "m" or "rad".
std::string_view DisplacementUnit(Dof dof);

// "m/s" or "rad/s".
std::string_view VelocityUnit(Dof dof);

// "N" or "N m".
std::string_view ForceUnit(Dof dof);

// Nothing if no DOF has this name.
std::optional<Dof> DofFromName(std::string_view name);

// Throws InputError, listing the names there are, if no DOF has this name: "is 'up', expected ...",
// for the name of a flag to be put before it.
Dof ParseDof(const std::string& name);

}  // namespace fathom
