// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/identification/identification.h"

#include <optional>
#include <string>
#include <vector>

namespace fathom {

// The options of the identifier families, as the tools' flags have them.
struct FamilyArguments {
  std::optional<std::vector<double>> gains;  // a_m, l1, l2, l3, l4
  std::string integrator = "runge_kutta";
  double huber = 3.0;
  double shooting_window = 600.0;  // [s]
  std::string weighting = "plain";
};

// Throws InputError for a name, a number or gains that cannot be used.
IdentificationOptions OptionsOf(const FamilyArguments& arguments);

}  // namespace fathom
