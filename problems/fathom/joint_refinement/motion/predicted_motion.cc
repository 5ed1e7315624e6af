// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/motion/predicted_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fathom {

UncoupledModel<double> MotionUnknowns::Model() const {
  return {
      std::exp(model[kInertia]), model[kQuadraticDamping], model[kLinearDamping], model[kBuoyancy]};
}

PredictedMotion::PredictedMotion(HeldCommand command,
                                 std::vector<double> time,
                                 int excited,
                                 const MotionScales& scales)
    : command_(std::move(command)),
      time_(std::move(time)),
      excited_(excited),
      scales_(scales),
      simulation_(command_, time_),
      force_(time_.size()),
      position_(time_.size()),
      velocity_(time_.size()),
      acceleration_(time_.size()),
      position_sensitivity_(time_.size() * kSensitivities),
      velocity_sensitivity_(time_.size() * kSensitivities) {}

void PredictedMotion::LayOut(double clock_offset) {
  std::vector<double> shifted = time_;
  for (double& t : shifted) t += clock_offset;
  simulation_ = Simulation(command_, shifted);
  force_ = command_.At(shifted);
  is_laid_out_ = true;
}

bool PredictedMotion::Update(const MotionUnknowns& unknowns) {
  if (!is_laid_out_ || unknowns.clock_offset != at_.clock_offset) LayOut(unknowns.clock_offset);
  at_ = unknowns;
  const UncoupledModel<double> model = at_.Model();
  if (!std::isfinite(model.inertia) || model.inertia <= 0.0) return false;
  if (!simulation_.RunWithSensitivities(model,
                                        {at_.start[0], at_.start[1]},
                                        velocity_,
                                        position_,
                                        velocity_sensitivity_,
                                        position_sensitivity_)) {
    return false;
  }
  for (size_t k = 0; k < size(); ++k)
    acceleration_[k] = model.Acceleration(velocity_[k], force_[k]);
  return true;
}

PoseVector PredictedMotion::Mean(size_t k) const {
  PoseVector eta;
  eta[excited_] = position_[k];
  for (int j = 0; j < kNumHeld; ++j) {
    const double* const c = &at_.response[static_cast<size_t>(j) * kResponseTerms];
    eta[HeldCoordinate(j)] = c[0] + c[1] * (position_[k] - at_.start[1]) / scales_.displacement +
                             c[2] * velocity_[k] / scales_.velocity +
                             c[3] * acceleration_[k] / scales_.acceleration;
  }
  return eta;
}

PredictedMotion::Derivatives PredictedMotion::MeanDerivatives(size_t k) const {
  // Rows: displacement, velocity, acceleration. Columns: the model with log inertia, the initial
  // velocity, the clock.
  constexpr int kClock = kSensitivities;
  Eigen::Matrix<double, 3, kSensitivities + 1> d;
  const double* const dx = &position_sensitivity_[k * kSensitivities];
  const double* const dv = &velocity_sensitivity_[k * kSensitivities];
  for (int i = 0; i < kSensitivities; ++i) {
    d(0, i) = dx[i];
    d(1, i) = dv[i];
  }
  // The state at the first frame stays what it is while the frames move along the command.
  d(0, kClock) = velocity_[k] - velocity_[0] - dx[kNumParameters] * acceleration_[0];
  d(1, kClock) = acceleration_[k] - dv[kNumParameters] * acceleration_[0];
  // a = (tau - d_Q v|v| - d_L v - b) / m
  const UncoupledModel<double> model = at_.Model();
  const double v = velocity_[k];
  const double by_v =
      -(model.linear_damping + 2.0 * model.quadratic_damping * std::abs(v)) / model.inertia;
  d.row(2) = by_v * d.row(1);
  d(2, kInertia) -= acceleration_[k] / model.inertia;
  d(2, kQuadraticDamping) -= v * std::abs(v) / model.inertia;
  d(2, kLinearDamping) -= v / model.inertia;
  d(2, kBuoyancy) -= 1.0 / model.inertia;
  d.col(kInertia) *= model.inertia;

  Derivatives D = Derivatives::Zero();
  const auto fill = [&](int row, const Eigen::RowVector3d& weights) {
    const Eigen::Matrix<double, 1, kSensitivities + 1> sum = weights * d;
    D.block<1, kModelColumns>(row, 0) = sum.head<kModelColumns>();
    D(row, kStartColumns) = sum[kNumParameters];
    D(row, kClockColumn) = sum[kClock];
  };
  fill(excited_, {1.0, 0.0, 0.0});
  D(excited_, kStartColumns + 1) = 1.0;
  const Eigen::RowVector4d regressors(1.0,
                                      (position_[k] - at_.start[1]) / scales_.displacement,
                                      v / scales_.velocity,
                                      acceleration_[k] / scales_.acceleration);
  for (int j = 0; j < kNumHeld; ++j) {
    const int row = HeldCoordinate(j);
    const double* const c = &at_.response[static_cast<size_t>(j) * kResponseTerms];
    fill(row, {c[1] / scales_.displacement, c[2] / scales_.velocity, c[3] / scales_.acceleration});
    D.block<1, kResponseTerms>(row, kResponseColumns + j * kResponseTerms) = regressors;
  }
  return D;
}

}  // namespace fathom
