// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/free_decay/decay_search.h"

#include "fathom/solve/root_huber.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <ceres/cost_function.h>
#include <ceres/problem.h>

namespace fathom {
namespace {

using JacobianMap =
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

// The residuals of all stretches, one by one under Huber's loss, by the block of all unknowns.
class DecayCost final : public ceres::CostFunction {
 public:
  // The stretches must outlive this.
  DecayCost(std::span<const DecayStretch> stretches,
            DecayOutput output,
            double sigma,
            double k,
            Eigen::Index num_samples)
      : stretches_(stretches), output_(output), sigma_(sigma), k_(k) {
    const int num_stretches = static_cast<int>(stretches.size());
    set_num_residuals(static_cast<int>(num_samples));
    mutable_parameter_block_sizes()->push_back(kNumDecayRates +
                                               DecayUnknowns::kPerStretch * num_stretches);
  }

  bool Evaluate(double const* const* blocks, double* residuals, double** jacobians) const override {
    const int num_unknowns = parameter_block_sizes().front();
    const Eigen::VectorXd point = Eigen::Map<const Eigen::VectorXd>(blocks[0], num_unknowns);
    const auto at = DecayResidualsAt(point, stretches_, output_);
    if (!at) return false;
    double* const jacobian = jacobians == nullptr ? nullptr : jacobians[0];
    for (Eigen::Index i = 0; i < at->residual.size(); ++i) {
      const RootHuber loss = RootHuber::Of(at->residual[i] / sigma_, k_);
      residuals[i] = loss.value;
      if (jacobian == nullptr) continue;
      JacobianMap(jacobian, num_residuals(), num_unknowns).row(i) =
          loss.derivative / sigma_ * at->jacobian.row(i);
    }
    return true;
  }

 private:
  const std::span<const DecayStretch> stretches_;
  const DecayOutput output_;
  const double sigma_, k_;
};

}  // namespace

std::vector<int> BoundedRates(const FreeDecayOptions& options) {
  std::vector<int> bounded = {kLinearRate, kQuadraticRate};
  if (options.has_stiffness) bounded.push_back(kStiffnessRate);
  return bounded;
}

DecayUnknowns::DecayUnknowns(std::size_t num_stretches, const FreeDecayOptions& options)
    : num_stretches_(static_cast<int>(num_stretches)) {
  fixed_.push_back(options.has_stiffness ? kConstantRate : kStiffnessRate);
  const bool is_velocity = options.output == DecayOutput::kVelocity;
  for (std::size_t s = 0; s < num_stretches; ++s) {
    // The displacement at the start acts through the stiffness alone, or is what is measured.
    if (is_velocity && !options.has_stiffness) fixed_.push_back(FirstOf(s) + 1);
    if (is_velocity || !options.has_stiffness) fixed_.push_back(FirstOf(s) + 2);
  }
}

std::optional<DecayResiduals> DecayResidualsAt(const Eigen::VectorXd& point,
                                               std::span<const DecayStretch> stretches,
                                               DecayOutput output) {
  DecayResiduals all;
  Eigen::Index n = 0;
  for (const DecayStretch& stretch : stretches) n += static_cast<Eigen::Index>(stretch.time.size());
  all.residual.resize(n);
  all.jacobian.setZero(n, point.size());
  const DecayRates rates = {point[0], point[1], point[2], point[3]};
  Eigen::Index row = 0, first = kNumDecayRates;
  bool is_first_sample = true;
  for (const DecayStretch& stretch : stretches) {
    all.begin.push_back(row);
    const std::vector<DecaySample> samples =
        SimulateDecay(rates, point[first], point[first + 1], stretch.time);
    if (samples.empty()) return std::nullopt;
    for (std::size_t i = 0; i < samples.size(); ++i, ++row) {
      const DecaySample& sample = samples[i];
      const bool is_velocity = output == DecayOutput::kVelocity;
      const DecayGradient& gradient =
          is_velocity ? sample.velocity_gradient : sample.displacement_gradient;
      const double value = is_velocity ? sample.velocity : sample.displacement + point[first + 2];
      all.residual[row] = value - stretch.motion[i];
      all.jacobian.row(row).head<kNumDecayRates>() = gradient.head<kNumDecayRates>();
      all.jacobian.row(row).segment<2>(first) = gradient.tail<2>();
      if (!is_velocity) all.jacobian(row, first + 2) = 1.0;
      const double speed = std::abs(sample.velocity);
      all.largest_speed = std::max(all.largest_speed, speed);
      all.smallest_speed = is_first_sample ? speed : std::min(all.smallest_speed, speed);
      is_first_sample = false;
    }
    first += DecayUnknowns::kPerStretch;
  }
  all.begin.push_back(row);
  return all;
}

DecayPoint SearchDecay(const Eigen::VectorXd& start,
                       std::span<const DecayStretch> stretches,
                       const FreeDecayOptions& options,
                       double sigma,
                       double k) {
  DecayPoint found = {start, {}};
  const auto first = DecayResidualsAt(start, stretches, options.output);
  if (!first) {
    found.solve.message = "The simulation does not stay finite.";
    return found;
  }
  double* const unknowns = found.unknowns.data();
  ceres::Problem problem;
  problem.AddResidualBlock(
      new DecayCost(stretches, options.output, sigma, k, first->residual.size()),
      nullptr,
      unknowns);
  found.solve = SolveWithBounds({.is_dense = true},
                                BoundedRates(options),
                                DecayUnknowns(stretches.size(), options).fixed(),
                                unknowns,
                                &problem);
  if (!found.solve.converged) found.solve.message = "The search did not converge.";
  return found;
}

}  // namespace fathom
