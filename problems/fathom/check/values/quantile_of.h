// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

namespace fathom {

// The value below which the share `level`, 0 to 1, of at least one value lies.
double QuantileOf(std::vector<double> values, double level);

}  // namespace fathom
