// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

namespace fathom {

// The value below which the share `share`, 0 to 1, of at least one value lies: of n in order the
// one at share (n - 1), rounded down.
double Quantile(std::vector<double> values, double share);

}  // namespace fathom
