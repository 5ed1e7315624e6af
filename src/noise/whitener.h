// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/noise/noise_model.h"

#include <array>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// Columns side by side, a row per sample: what is whitened in one go.
using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// The linear map W that turns noise of a model into white noise of variance 1:
//
//   W S W' = I,   S the covariance of the samples       docs/residual_noise.md (7)
//
// It is the Kalman filter of the model; its gains depend on the sampling only and are computed
// once, in the constructor. W is lower triangular: row i uses samples up to i. Any column of the
// length of the samples may be whitened: residual, sensitivities, signatures. About 5 ns per value
// in blocks.
//
// Each sample needs a positive variance of its own, given those before it; a channel with neither
// white nor coloured noise is a broken precondition.
class Whitener {
 public:
  // The gains at one sample; the state is (w, v', x', coloured velocity noise, coloured
  // displacement noise), docs/residual_noise.md (4).
  struct Step {
    static constexpr int kNumStates = 5;
    // The non-zero entries of the transition from the sample before; x from x is `keep_x`, which is
    // 1, or 0 at the start of a segment, as the others are.
    double w_from_w, v_from_w, v_from_v, x_from_w, x_from_v, keep_x, velocity_c, displacement_c;
    double inverse_std;                   // of the innovation
    std::array<double, kNumStates> gain;  // of the state on the whitened innovation
    NoiseChannel channel;
  };

  Whitener(const NoiseModel& model, std::span<const NoiseSample> samples);

  int num_samples() const { return static_cast<int>(steps_.size()); }

  // out = W in; both of length num_samples(); they may be the same. Allocates nothing.
  void Apply(std::span<const double> in, std::span<double> out) const;

  // out = W in for all columns of a block of num_samples() rows; they may be the same.
  void Apply(const Eigen::Ref<const RowMajorMatrix>& in, Eigen::Ref<RowMajorMatrix> out) const;

  // log det S.
  double log_determinant() const { return log_determinant_; }

  // log p(e) = -1/2 (|W e|^2 + log det S + n log 2 pi).
  double LogLikelihood(std::span<const double> residual) const;

  // log of the variance of each sample given those before it.
  const std::vector<double>& log_variances() const { return log_variances_; }

 private:
  std::vector<Step> steps_;
  std::vector<double> log_variances_;
  double log_determinant_ = 0.0;
};

}  // namespace fathom
