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

}  // namespace fathom
