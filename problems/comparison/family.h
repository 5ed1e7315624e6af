// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <string>
#include <string_view>

namespace fathom {

// A way to get parameters out of signals.
enum class Family { kLeastSquares, kAdaptive, kOutputError };

inline constexpr std::array<Family, 3> kAllFamilies = {
    Family::kLeastSquares, Family::kAdaptive, Family::kOutputError};

// "least_squares", "adaptive", "output_error".
std::string_view Name(Family family);

// Throws InputError, listing the names there are, in the form of ParseDof().
Family ParseFamily(const std::string& name);

}  // namespace fathom
