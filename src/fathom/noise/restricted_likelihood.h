// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/noise/noise_model.h"
#include "fathom/noise/whitener.h"

#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// The likelihood of a noise model for the part of a residual that the columns of a design cannot
// explain, docs/residual_noise.md (9); without columns, the plain likelihood (8). All standard
// deviations of the model may be multiplied by one factor; it is chosen in closed form.
class RestrictedLikelihood {
 public:
  struct Value {
    double log_likelihood;  // at the best factor
    double factor;          // on all standard deviations of the model
    // What is left of the whitened residual, divided by the factor: variance about 1.
    std::vector<double> standardised;
    std::vector<double> log_variances;  // of each sample given those before, without the factor
  };

  // Columns of `design` that depend on others count once. The samples must outlive this object.
  RestrictedLikelihood(std::span<const NoiseSample> samples,
                       std::span<const double> residual,
                       const Eigen::Ref<const RowMajorMatrix>& design);

  Value At(const NoiseModel& model) const;

  std::span<const NoiseSample> samples() const { return samples_; }

  // Rank of the design.
  int rank() const { return rank_; }

  // Root mean square of what the design leaves of a channel; 0 without samples in it.
  double RootMeanSquare(NoiseChannel channel) const;

 private:
  std::span<const NoiseSample> samples_;
  int rank_ = 0;
  // An orthonormal base of the design, the projected residual, zeros up to a multiple of 4 columns.
  RowMajorMatrix columns_;
};

}  // namespace fathom
