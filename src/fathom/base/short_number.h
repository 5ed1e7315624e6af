// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace fathom {

// A number for a person, rounded to so many digits: "0.13", "2", "1200". From 1e-4 on it has no
// exponent, where {:.2g} writes 1.2e+03.
std::string ShortNumber(double value, int digits);

}  // namespace fathom
