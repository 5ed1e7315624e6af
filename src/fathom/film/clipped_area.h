// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>

#include <Eigen/Core>

namespace fathom {

// Area of a convex quadrangle, at least 0 whichever way round its corners run.
double AreaOf(const std::array<Eigen::Vector2d, 4>& quadrangle);

// Area of the part of a convex quadrangle that lies within the rectangle from `low` to `high`.
double AreaWithin(const std::array<Eigen::Vector2d, 4>& quadrangle,
                  const Eigen::Vector2d& low,
                  const Eigen::Vector2d& high);

}  // namespace fathom
