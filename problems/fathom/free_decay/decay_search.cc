// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/free_decay/decay_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Cholesky>

namespace fathom {

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

DecaySearch::DecaySearch(std::span<const DecayStretch> stretches,
                         DecayOutput output,
                         std::vector<int> fixed,
                         double sigma,
                         double k,
                         Eigen::VectorXd* point)
    : stretches_(stretches),
      output_(output),
      fixed_(std::move(fixed)),
      sigma_(sigma),
      k_(k),
      point_(point) {}

double DecaySearch::CostOf(const Eigen::VectorXd& residual) const {
  double cost = 0.0;
  for (const double value : residual) {
    const double r = std::abs(value) / sigma_;
    cost += r <= k_ ? r * r / 2.0 : k_ * r - k_ * k_ / 2.0;
  }
  return cost;
}

BoundedSearch::Optimum DecaySearch::Solve(const std::vector<int>& held) {
  constexpr int kMostIterations = 60;
  constexpr double kSmallestGain = 1e-11, kMostDamping = 1e12;
  std::vector<bool> is_still(static_cast<std::size_t>(point_->size()), false);
  for (const int unknown : fixed_) is_still[static_cast<std::size_t>(unknown)] = true;
  for (const int unknown : held) is_still[static_cast<std::size_t>(unknown)] = true;

  Optimum optimum;
  auto now = DecayResidualsAt(*point_, stretches_, output_);
  if (!now) {
    optimum.message = "The simulation does not stay finite.";
    return optimum;
  }
  optimum.cost = CostOf(now->residual);
  double damping = 1e-3;
  for (int iteration = 0; iteration < kMostIterations; ++iteration) {
    Eigen::VectorXd weight(now->residual.size());
    for (Eigen::Index i = 0; i < weight.size(); ++i) {
      const double r = std::abs(now->residual[i]) / sigma_;
      weight[i] = (r <= k_ ? 1.0 : k_ / r) / (sigma_ * sigma_);
    }
    const Eigen::MatrixXd weighted = weight.asDiagonal() * now->jacobian;
    Eigen::MatrixXd H = weighted.transpose() * now->jacobian;
    Eigen::VectorXd g = weighted.transpose() * now->residual;
    for (Eigen::Index j = 0; j < g.size(); ++j) {
      if (!is_still[static_cast<std::size_t>(j)] && H(j, j) > 0.0) continue;
      H.row(j).setZero();
      H.col(j).setZero();
      H(j, j) = 1.0;
      g[j] = 0.0;
    }
    bool has_moved = false;
    double gain = 0.0;
    while (damping < kMostDamping) {
      Eigen::MatrixXd damped = H;
      damped.diagonal() *= 1.0 + damping;
      const Eigen::VectorXd trial = *point_ - damped.ldlt().solve(g);
      auto there = DecayResidualsAt(trial, stretches_, output_);
      const double cost = there ? CostOf(there->residual) : optimum.cost;
      if (there && cost < optimum.cost) {
        gain = optimum.cost - cost;
        optimum.cost = cost;
        *point_ = trial;
        now = std::move(there);
        damping = std::max(damping / 10.0, 1e-12);
        has_moved = true;
        break;
      }
      damping *= 10.0;
    }
    // Where no step lowers the cost, it is at its rounding.
    if (!has_moved || gain <= kSmallestGain * optimum.cost) {
      optimum.converged = true;
      return optimum;
    }
  }
  optimum.message = "The search did not converge.";
  return optimum;
}

std::vector<double> DecaySearch::Point() const { return {point_->begin(), point_->end()}; }

void DecaySearch::GoTo(const std::vector<double>& point) {
  *point_ = Eigen::Map<const Eigen::VectorXd>(point.data(), point_->size());
}

}  // namespace fathom
