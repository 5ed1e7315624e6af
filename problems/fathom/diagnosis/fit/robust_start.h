// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/data/measured_segments.h"
#include "fathom/vehicle/extended_model.h"

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// Output error's robust answer, which fathom_identify would give, and the states the segments start
// from. The fits start here, and what they gain is measured against it.
struct RobustStart {
  ExtendedModel model;
  std::vector<InitialState> initial;
  Eigen::MatrixXd covariance;  // of the baseline's parameters
};

// The baseline by output error (problems/output_error), from a guess of its own; nothing if it does
// not converge to a physical model.
std::optional<RobustStart> FindRobustStart(std::span<const MeasuredSegment> segments);

}  // namespace fathom
