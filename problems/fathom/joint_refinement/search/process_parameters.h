// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/processes/process_set.h"

#include <array>
#include <cmath>

#include <Eigen/Core>

namespace fathom {

// The numbers of a ProcessSet that are searched, as a vector of logarithms: those of the components
// that are present.
class ProcessParameters {
 public:
  explicit ProcessParameters(const ProcessSet& base) : base_(base) {
    for (int j = 0; j < kNumHeld; ++j) {
      if (!base.wander[j].IsPresent()) continue;
      wander_[j] = size_;
      size_ += 3;
    }
    for (int j = 0; j < kNumHeld; ++j) {
      if (base.response_std[j] > 0.0) response_[j] = size_++;
    }
    if (base.model_error > 0.0) model_error_ = size_++;
    corner_sigma_ = size_++;
  }

  int size() const { return size_; }

  // Index of the first of a component's numbers, -1 if it is absent.
  int wander(int j) const { return wander_[j]; }  // of std, frequency, ratio
  int response(int j) const { return response_[j]; }
  int model_error() const { return model_error_; }  // of the root of the intensity
  int corner_sigma() const { return corner_sigma_; }

  Eigen::VectorXd ToVector() const {
    Eigen::VectorXd x(size_);
    for (int j = 0; j < kNumHeld; ++j) {
      if (wander_[j] >= 0) {
        const HeldWander& w = base_.wander[j];
        x.segment<3>(wander_[j]) << std::log(w.std), std::log(w.frequency), std::log(w.ratio);
      }
      if (response_[j] >= 0) x[response_[j]] = std::log(base_.response_std[j]);
    }
    if (model_error_ >= 0) x[model_error_] = 0.5 * std::log(base_.model_error);
    x[corner_sigma_] = std::log(base_.corner_sigma);
    return x;
  }

  ProcessSet FromVector(const Eigen::VectorXd& x) const {
    ProcessSet set = base_;
    for (int j = 0; j < kNumHeld; ++j) {
      if (const int i = wander_[j]; i >= 0) {
        set.wander[j] = {std::exp(x[i]), std::exp(x[i + 1]), std::exp(x[i + 2])};
      }
      if (response_[j] >= 0) set.response_std[j] = std::exp(x[response_[j]]);
    }
    if (model_error_ >= 0) set.model_error = std::exp(2.0 * x[model_error_]);
    set.corner_sigma = std::exp(x[corner_sigma_]);
    return set;
  }

 private:
  ProcessSet base_;
  int size_ = 0;
  std::array<int, kNumHeld> wander_ = {-1, -1, -1, -1, -1};
  std::array<int, kNumHeld> response_ = {-1, -1, -1, -1, -1};
  int model_error_ = -1, corner_sigma_ = -1;
};

}  // namespace fathom
