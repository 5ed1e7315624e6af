// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/coupled/manoeuvre_figures.h"
#include "fathom/simulate/coupled/steering.h"

#include <optional>
#include <string_view>
#include <vector>

namespace fathom {

// How the tables of naval architects count.
enum class SteeringUnits {
  kSi,
  kPrime,  // by rho/2 of fresh water, the vehicle's length and the speed
};

// "si", "prime". Throws InputError, with what is expected, for anything else.
SteeringUnits ParseSteeringUnits(std::string_view text);

// The derivatives of `equations` at a speed ahead [m/s], and NomotoOf() them. `length`: of the
// vehicle [m]; then all are divided by rho/2 and powers of length and speed.
std::vector<ManoeuvreFigure> DerivativesOf(const SteeringEquations& equations,
                                           double ahead,
                                           std::optional<double> length);

}  // namespace fathom
