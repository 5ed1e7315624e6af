// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/output_error/learned/binned_segment.h"
#include "fathom/vehicle/parameters.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <optional>
#include <span>

namespace fathom {

// What of each free run is fitted to it alone: where logs have offsets of their own, no run that a
// fit has not seen has a known one.
enum class Refitted { kState, kStateAndOffset };

// What free runs of a model miss of the data, over the bins. Each lasts a minute at most and starts
// from the state that fits best.
struct FreeRuns {
  double sum_of_squares = 0.0;  // |e|^2 [unit of the output, squared]

  // J' J: how the runs follow the parameters, what is Refitted eliminated.
  ParameterCovariance gram = ParameterCovariance::Zero();

  // The sum of squares to be expected of data that a fit of covariance C has not seen:
  //
  //   |e|^2 + 2 trace(J' J C)                                    docs/output_error.md (13)
  //
  // B. Efron, The estimation of prediction error: covariance penalties and cross-validation, JASA
  // 99, 2004.
  double ExpectedOfLeftOutData(const ParameterCovariance& covariance) const {
    return sum_of_squares + 2.0 * (gram * covariance).trace();
  }
};

// `models`: of each segment, which differ by their buoyancy at most. Nothing if a run diverges.
std::optional<FreeRuns> FreeRunsOf(std::span<const UncoupledModel<double>> models,
                                   std::span<const BinnedSegment> bins,
                                   Refitted refitted = Refitted::kState);

}  // namespace fathom
