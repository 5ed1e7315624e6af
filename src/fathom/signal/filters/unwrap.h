// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <vector>

namespace fathom {

// Angles [rad] without the jumps at +-pi: each the one of its equals that is nearest to the angle
// before it. The first stays as it is.
std::vector<double> Unwrap(std::span<const double> angles);

}  // namespace fathom
