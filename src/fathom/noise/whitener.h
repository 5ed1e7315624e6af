// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/noise/noise_model.h"
#include "fathom/noise/whitening_step.h"

#include <cstddef>
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
  Whitener(const NoiseModel& model, std::span<const NoiseSample> samples);

  int num_samples() const { return static_cast<int>(step_of_.size()); }

  // out = W in; both of length num_samples(); they may be the same. Allocates nothing.
  void Apply(std::span<const double> in, std::span<double> out) const;

  // out = W in for all columns of a block of num_samples() rows; they may be the same.
  void Apply(const Eigen::Ref<const RowMajorMatrix>& in, Eigen::Ref<RowMajorMatrix> out) const;

  // The first sample of each segment, and num_samples(). W has no entries between segments.
  const std::vector<int>& first_rows() const { return first_rows_; }

  // The same for the rows of segment `index` alone.
  void ApplyToSegment(std::size_t index,
                      const Eigen::Ref<const RowMajorMatrix>& in,
                      Eigen::Ref<RowMajorMatrix> out) const;

  // log det S.
  double log_determinant() const { return log_determinant_; }

  // log p(e) = -1/2 (|W e|^2 + log det S + n log 2 pi).
  double LogLikelihood(std::span<const double> residual) const;

  // log of the variance of each sample given those before it.
  std::vector<double> LogVariances() const;

 private:
  // To the rows whose steps these are.
  void ApplySteps(std::span<const int> step_of,
                  const Eigen::Ref<const RowMajorMatrix>& in,
                  Eigen::Ref<RowMajorMatrix> out) const;

  template <typename Function>
  void WithStates(const Function& function) const;

  // How many of (w, v', x') are in the state (0, 2 or 3), and which coloured noises.
  int num_disturbance_states_ = 0;
  bool has_velocity_c_ = false, has_displacement_c_ = false;
  std::vector<int> first_rows_;
  std::vector<int> step_of_;          // of each sample, into:
  std::vector<WhiteningStep> steps_;  // the different ones; a stationary filter has few
  double log_determinant_ = 0.0;
};

}  // namespace fathom
