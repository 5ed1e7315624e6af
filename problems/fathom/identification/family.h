// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <string>
#include <string_view>

namespace fathom {

// A way to get parameters out of a log.
enum class Family { kLeastSquares, kAdaptive, kOutputError, kJoint };

inline constexpr std::array<Family, 4> kAllFamilies = {
    Family::kLeastSquares, Family::kAdaptive, Family::kOutputError, Family::kJoint};

// Those that work on signals. The joint refinement works on the corners of markers instead:
// joint_identification.h.
inline constexpr std::array<Family, 3> kSignalFamilies = {
    Family::kLeastSquares, Family::kAdaptive, Family::kOutputError};

// "least_squares", "adaptive", "output_error", "joint".
std::string_view Name(Family family);

// One of kAllFamilies, or of kSignalFamilies. Throw InputError, listing their names, in the form of
// ParseDof().
Family ParseFamily(const std::string& name);
Family ParseSignalFamily(const std::string& name);

}  // namespace fathom
