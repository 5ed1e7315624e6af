// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/held_command.h"

#include <span>
#include <vector>

namespace fathom {

// Integral of sampled values from the first stamp to each stamp, by the trapezoidal rule.
std::vector<double> Integral(std::span<const double> time, std::span<const double> values);

// First and second integral of a held command from the first stamp to each stamp, exact whatever
// the command does between the stamps.
struct CommandIntegrals {
  std::vector<double> once;   // [N s] or [N m s]
  std::vector<double> twice;  // [N s^2] or [N m s^2]
};

CommandIntegrals IntegralsOf(const HeldCommand& command, std::span<const double> time);

}  // namespace fathom
