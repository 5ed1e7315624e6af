// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/problem/make_clipped_loss.h"

#include "fathom/joint_refinement/problem/clipped_loss.h"

#include <ceres/loss_function.h>

namespace fathom {
namespace {

class Loss final : public ceres::LossFunction {
 public:
  explicit Loss(double limit) : limit_(limit) {}
  void Evaluate(double s, double rho[3]) const override {
    const ClippedLoss loss = ClippedLoss::Of(s, limit_);
    rho[0] = loss.value;
    rho[1] = loss.weight;
    rho[2] = loss.second_derivative;
  }

 private:
  const double limit_;
};

}  // namespace

std::unique_ptr<ceres::LossFunction> MakeClippedLoss(double limit) {
  return std::make_unique<Loss>(limit);
}

}  // namespace fathom
