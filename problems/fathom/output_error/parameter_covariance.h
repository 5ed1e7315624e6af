// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/output_error/offset_sharing.h"
#include "fathom/output_error/shooting_window.h"
#include "fathom/output_error/signatures.h"
#include "fathom/signal/filters/autoregression.h"
#include "fathom/simulate/simulate.h"
#include "fathom/vehicle/parameters.h"

#include <limits>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// What the data say about the parameters at the optimum. NaN where not computed.
struct ParameterEvidence {
  static constexpr double kNotComputed = std::numeric_limits<double>::quiet_NaN();

  // Sandwich covariance with the residuals' own colour, docs/output_error.md (7); and what it would
  // be if a time offset of the command were to be fitted too (EFFECTS.md's `time_offset`): infinite
  // if the parameters imitate an offset exactly.
  ParameterCovariance covariance = ParameterCovariance::Constant(kNotComputed);
  ParameterCovariance covariance_with_time_offset = ParameterCovariance::Constant(kNotComputed);

  // Share of each parameter's signature in the output that the other parameters and the initial
  // states cannot imitate, 0 to 1; and with a time offset among those others.
  ParameterVector share = ParameterVector::Constant(kNotComputed);
  ParameterVector share_with_time_offset = ParameterVector::Constant(kNotComputed);

  // How the parameters would follow a time offset of the command: the fit's change per second.
  ParameterVector change_per_second_of_offset = ParameterVector::Constant(kNotComputed);

  // Of each offset, where logs have their own; [force squared].
  Eigen::VectorXd offset_variance;

  // Ratio of the largest to the smallest singular value of the scaled signatures.
  double condition_number = kNotComputed;

  Autoregression noise;                     // of the whitened residuals
  double noise_correlation = kNotComputed;  // of neighbouring residuals
};

// `models` and `initial_states` have one entry per segment: the models differ by their buoyancy at
// most, where logs have `offsets` of their own. `sigma` and
// `huber_k` as in ShootingWindow. Returns an empty-handed evidence (NaN) if a simulation diverges
// or some direction leaves no trace at all.
ParameterEvidence EvidenceAt(std::span<const UncoupledModel<double>> models,
                             std::span<const Segment> segments,
                             std::span<const InitialState> initial_states,
                             FittedOutput output,
                             double sigma,
                             double huber_k,
                             const OffsetSharing& offsets = {});

// The same from rows whose residuals are about white and of variance 1, weighed by plain squares:
// consecutive ones of a segment each.
ParameterEvidence EvidenceOf(std::span<const Samples> whitened, const OffsetSharing& offsets = {});

}  // namespace fathom
