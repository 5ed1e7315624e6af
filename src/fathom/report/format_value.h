// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <limits>
#include <string>
#include <string_view>

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

// A unit as texts show it, with raised figures: "kg m^2/s" as "kg m²/s". Files hold the plain form.
std::string UnitText(std::string_view unit);

// The same interval within a sentence: "0.42 s (0.39 to 0.45 s)". Rounded at DecimalsFor() its half
// width; the ends do not pass the bounds. Without a known standard deviation the number alone, to
// four digits.
std::string WithInterval(
    double value, double std, std::string_view unit, double lower, double upper);

// Decimals that show the first digit of `size`, or its second if the first is a 1; below 0 they
// stand before the point.
int DecimalsFor(double size);

// The number with so many decimals: "1090" of 1086 with -1. With more than six, and of a million
// and beyond, as many significant digits as end there, three at least: "0.0005994", "1.2346e+08".
std::string RoundedAt(double value, int decimals);

// A share such as an NMAE with so many decimals, or, where these would leave less than two digits
// of it, with two: "0.013", "1.1e-05". "-" of what is not finite.
std::string ShareText(double share, int decimals);

}  // namespace fathom
