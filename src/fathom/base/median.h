// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <vector>

namespace fathom {

// The middle one of at least one value; of an even number of them the upper of the middle two.
double Median(std::vector<double> values);

// The median step between at least two stamps that follow each other.
double MedianStep(std::span<const double> time);

}  // namespace fathom
