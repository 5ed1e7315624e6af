// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/identification/identification.h"
#include "fathom/report/table.h"

#include <string>

namespace fathom {

// One family's result for a terminal: parameters with 95 % intervals, ratios where the command's
// unit leaves only those meaningful, figures of fit, and what the intervals do not cover.
// `velocity_file` is what the velocities were read from.
std::string FormatIdentification(const Identification& identification,
                                 const std::string& velocity_file = "velocity.csv");

// The parameters of a usable result with their 95 % intervals, and their ratios where only these
// are of the vehicle.
Table IdentificationTable(const Identification& identification);

// "Least squares, velocity.csv", "Output error, camera": the rows of the paper's Table II.
std::string ModelName(const Identification& identification);

// A ratio of two parameters with its standard deviation, by the delta method.
struct Ratio {
  double value = 0.0;
  double std = 0.0;
};
Ratio RatioOf(const FittedModel& fitted, int numerator, int denominator);

}  // namespace fathom
