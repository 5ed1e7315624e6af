// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/problem/joint_state.h"

#include <vector>

#include <ceres/evaluation_callback.h>

namespace fathom {

// Simulates every segment once per point, before Ceres asks any corner.
class MotionCallback final : public ceres::EvaluationCallback {
 public:
  MotionCallback(JointData* data, const JointUnknowns* unknowns, bool is_model_held)
      : data_(data),
        unknowns_(unknowns),
        is_model_held_(is_model_held),
        is_valid_(data->segments.size(), false) {}

  void PrepareForEvaluation(bool /*evaluate_jacobians*/, bool new_evaluation_point) override {
    if (is_prepared_ && (!new_evaluation_point || is_model_held_)) return;
    for (size_t r = 0; r < data_->segments.size(); ++r) {
      is_valid_[r] = data_->segments[r].motion.Update(unknowns_->Motion(r));
    }
    is_prepared_ = true;
  }

  bool is_valid(size_t segment) const { return is_valid_[segment]; }

 private:
  JointData* const data_;
  const JointUnknowns* const unknowns_;
  const bool is_model_held_;
  std::vector<char> is_valid_;
  bool is_prepared_ = false;
};

}  // namespace fathom
