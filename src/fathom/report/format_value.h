// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <limits>
#include <string>

namespace fathom {

// A number with its standard deviation, as many digits as the latter justifies: it gets two, and
// the number ends at the same place. "890.3 ± 4.2", "12350 ± 230", "(1.234 ± 0.056)e-05".
//
//   std NaN       four significant digits and no ±: "890.3"
//   std infinite  the same and "± inf"
//   value NaN     "-"
std::string FormatValue(double value, double std = std::numeric_limits<double>::quiet_NaN());

// The 95 % interval of the same number, both ends rounded at its last digit: "882.1 ... 898.5",
// "(1.124 ... 1.344)e-05". It does not reach below `lower_bound`, unless the value itself does.
// "-" where the deviation is not known or infinite.
std::string FormatInterval(double value,
                           double std,
                           double lower_bound = -std::numeric_limits<double>::infinity());

}  // namespace fathom
