// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>

namespace fathom {

// Half width of a 95 % interval, in standard deviations.
inline constexpr double kDeviationsOf95 = 1.96;

// Decimals that show the first digit of `size`, or its second if the first is a 1; below 0 they
// stand before the point.
int DecimalsFor(double size);

// The number with so many decimals: "1090" of 1086 with -1. No more than six, and none of a million
// and beyond, which get three digits and a power of ten.
std::string RoundedAt(double value, int decimals);

// "0.42 s (0.39 to 0.45 s)": the number with its 95 % interval, rounded at the first digit of the
// interval's half width (the second, if the first is a 1); the interval ends at the bounds. Without
// a known standard deviation the number alone, to four digits.
std::string WithInterval(
    double value, double std, std::string_view unit, double lower, double upper);

}  // namespace fathom
