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

namespace {

// The frames, and instants between those that are further apart than a lag's input may be straight.
std::vector<double> NodesOf(const std::vector<double>& time, std::vector<size_t>* node) {
  constexpr double kLongestStep = 0.2;  // [s]
  std::vector<double> nodes;
  for (size_t k = 0; k < time.size(); ++k) {
    if (k > 0) {
      const double gap = time[k] - time[k - 1];
      const double num_steps = std::ceil(gap / kLongestStep);
      for (double i = 1.0; i < num_steps; ++i) nodes.push_back(time[k - 1] + i / num_steps * gap);
    }
    node->push_back(nodes.size());
    nodes.push_back(time[k]);
  }
  return nodes;
}

}  // namespace

PredictedMotion::PredictedMotion(HeldCommand command,
                                 std::vector<double> time,
                                 int excited,
                                 const MotionScales& scales)
    : command_(std::move(command)),
      time_(std::move(time)),
      nodes_(NodesOf(time_, &node_)),
      excited_(excited),
      scales_(scales),
      simulation_(command_, nodes_),
      force_(nodes_.size()),
      position_(nodes_.size()),
      velocity_(nodes_.size()),
      acceleration_(nodes_.size()),
      position_sensitivity_(nodes_.size() * kSensitivities),
      velocity_sensitivity_(nodes_.size() * kSensitivities) {}

void PredictedMotion::LayOut(double clock_offset) {
  std::vector<double> shifted = nodes_;
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
  for (size_t i = 0; i < nodes_.size(); ++i)
    acceleration_[i] = model.Acceleration(velocity_[i], force_[i]);
  FollowWithLags();
  return true;
}

void PredictedMotion::FollowWithLags() {
  SignalRows acceleration(nodes_.size(), 1 + kSlopes);
  for (size_t i = 0; i < nodes_.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    acceleration(row, 0) = acceleration_[i];
    acceleration.row(row).tail<kSlopes>() = StateSlopes(i).row(2);
  }
  for (size_t i = 0; i < kResponseLags.size(); ++i) {
    lagged_[i] = Lagged(nodes_, kResponseLags[i], acceleration);
  }
}

Eigen::Vector<double, kNumRegressors> PredictedMotion::Regressors(size_t k) const {
  const size_t node = node_[k];
  Eigen::Vector<double, kNumRegressors> regressors;
  regressors[0] = (position_[node] - at_.start[1]) / scales_.displacement;
  regressors[1] = velocity_[node] / scales_.velocity;
  regressors[2] = acceleration_[node] / scales_.acceleration;
  for (size_t i = 0; i < kResponseLags.size(); ++i) {
    regressors[3 + i] = lagged_[i](static_cast<Eigen::Index>(node), 0) / scales_.acceleration;
  }
  return regressors;
}

PoseVector PredictedMotion::Mean(size_t k) const {
  const auto regressors = Regressors(k);
  PoseVector eta;
  eta[excited_] = position_[node_[k]];
  for (int j = 0; j < kNumHeld; ++j) {
    const double* const c = &at_.response[static_cast<size_t>(j) * kResponseTerms];
    eta[HeldCoordinate(j)] =
        c[0] + Eigen::Map<const Eigen::Vector<double, kNumRegressors>>(c + 1).dot(regressors);
  }
  return eta;
}

// Rows: displacement, velocity, acceleration. Columns: the model with log inertia, the initial
// velocity, the clock.
Eigen::Matrix<double, 3, PredictedMotion::kSlopes> PredictedMotion::StateSlopes(size_t node) const {
  constexpr int kClock = kSensitivities;
  Eigen::Matrix<double, 3, kSlopes> d;
  const double* const dx = &position_sensitivity_[node * kSensitivities];
  const double* const dv = &velocity_sensitivity_[node * kSensitivities];
  for (int i = 0; i < kSensitivities; ++i) {
    d(0, i) = dx[i];
    d(1, i) = dv[i];
  }
  // The state at the first frame stays what it is while the frames move along the command.
  d(0, kClock) = velocity_[node] - velocity_[0] - dx[kNumParameters] * acceleration_[0];
  d(1, kClock) = acceleration_[node] - dv[kNumParameters] * acceleration_[0];
  // a = (tau - d_Q v|v| - d_L v - b) / m
  const UncoupledModel<double> model = at_.Model();
  const double v = velocity_[node];
  const double by_v =
      -(model.linear_damping + 2.0 * model.quadratic_damping * std::abs(v)) / model.inertia;
  d.row(2) = by_v * d.row(1);
  d(2, kInertia) -= acceleration_[node] / model.inertia;
  d(2, kQuadraticDamping) -= v * std::abs(v) / model.inertia;
  d(2, kLinearDamping) -= v / model.inertia;
  d(2, kBuoyancy) -= 1.0 / model.inertia;
  d.col(kInertia) *= model.inertia;
  return d;
}

Eigen::Matrix<double, kNumRegressors, PredictedMotion::kSlopes> PredictedMotion::RegressorSlopes(
    size_t k) const {
  Eigen::Matrix<double, kNumRegressors, kSlopes> slopes;
  slopes.topRows<3>() = StateSlopes(node_[k]);
  slopes.row(0) /= scales_.displacement;
  slopes.row(1) /= scales_.velocity;
  slopes.row(2) /= scales_.acceleration;
  for (size_t i = 0; i < kResponseLags.size(); ++i) {
    slopes.row(3 + static_cast<Eigen::Index>(i)) =
        lagged_[i].row(static_cast<Eigen::Index>(node_[k])).tail<kSlopes>() / scales_.acceleration;
  }
  return slopes;
}

PredictedMotion::Derivatives PredictedMotion::MeanDerivatives(size_t k) const {
  Derivatives D = Derivatives::Zero();
  const auto fill = [&](int row, const Eigen::RowVector<double, kSlopes>& slopes) {
    D.block<1, kModelColumns>(row, 0) = slopes.head<kModelColumns>();
    D(row, kStartColumns) = slopes[kNumParameters];
    D(row, kClockColumn) = slopes[kSensitivities];
  };
  fill(excited_, StateSlopes(node_[k]).row(0));
  D(excited_, kStartColumns + 1) = 1.0;
  const auto regressors = Regressors(k);
  const auto slopes = RegressorSlopes(k);
  for (int j = 0; j < kNumHeld; ++j) {
    const int row = HeldCoordinate(j);
    const double* const c = &at_.response[static_cast<size_t>(j) * kResponseTerms];
    fill(row, Eigen::Map<const Eigen::RowVector<double, kNumRegressors>>(c + 1) * slopes);
    const int first = kResponseColumns + j * kResponseTerms;
    D(row, first) = 1.0;
    D.block<1, kNumRegressors>(row, first + 1) = regressors.transpose();
  }
  return D;
}

}  // namespace fathom
