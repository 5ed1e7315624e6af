// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/shooting_window.h"

#include "fathom/solve/decompositions.h"
#include "fathom/solve/root_huber.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <ceres/cost_function.h>
#include <glog/logging.h>

namespace fathom {
namespace {

constexpr int kInitialVelocity = kNumParameters;  // column of the sensitivities

std::span<const double> OutputTimes(const ShootingWindow& window) {
  const size_t past_end = window.end + (window.continuity_sigma > 0.0 ? 1 : 0);
  return std::span(window.segment->time).subspan(window.begin, past_end - window.begin);
}

InitialState StateFromBlock(FittedOutput output, const double* state) {
  return {state[0], output == FittedOutput::kPosition ? state[1] : 0.0};
}

class WindowCost final : public ceres::CostFunction {
 public:
  WindowCost(const ShootingWindow& window, std::shared_ptr<SimulationScratch> scratch)
      : window_(window),
        state_size_(StateSize(window.output)),
        num_columns_(kNumParameters + state_size_),
        simulation_(window.segment->command, OutputTimes(window)),
        scratch_(std::move(scratch)) {
    const bool continues = window.continuity_sigma > 0.0;
    set_num_residuals(num_columns_ + 1 + (continues ? state_size_ : 0));
    mutable_parameter_block_sizes()->push_back(kBuoyancy);
    mutable_parameter_block_sizes()->push_back(1);
    mutable_parameter_block_sizes()->push_back(state_size_);
    if (continues) mutable_parameter_block_sizes()->push_back(state_size_);
  }

  bool Evaluate(const double* const* parameters,
                double* residuals,
                double** jacobians) const override {
    if (!Linearise(parameters)) return false;
    const int num_continuity = num_residuals() - num_columns_ - 1;
    std::copy_n(residuals_.data(), num_columns_ + 1, residuals);
    for (int k = 0; k < num_continuity; ++k) {
      residuals[num_columns_ + 1 + k] = reached_[k] - parameters[3][k] / window_.continuity_sigma;
    }
    if (jacobians == nullptr) return true;
    CopyColumns(0, kBuoyancy, jacobians[0]);
    CopyColumns(kBuoyancy, 1, jacobians[1]);
    CopyColumns(kNumParameters, state_size_, jacobians[2]);
    if (num_continuity == 0 || jacobians[3] == nullptr) return true;
    Eigen::Map<RowMajorMatrix> by_next(jacobians[3], num_residuals(), state_size_);
    by_next.setZero();
    by_next.bottomRows(num_continuity).diagonal().setConstant(-1.0 / window_.continuity_sigma);
    return true;
  }

 private:
  static constexpr int kMostColumns = kNumParameters + 2;
  using Row = Eigen::Matrix<double, 1, kMostColumns>;
  using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  // Of jacobian_, to where Ceres wants them; null: nowhere.
  void CopyColumns(int first, int count, double* to) const {
    if (to == nullptr) return;
    Eigen::Map<RowMajorMatrix>(to, num_residuals(), count) = jacobian_.middleCols(first, count);
  }

  // Fills residuals_, reached_ and jacobian_ at this point. Ceres asks for the residuals at a trial
  // point and, if it is accepted, for the Jacobian at the same point: simulate once with
  // derivatives and remember the point by its values.
  bool Linearise(const double* const* blocks) const {
    trial_point_.assign(blocks[0], blocks[0] + kBuoyancy);
    trial_point_.push_back(*blocks[1]);
    trial_point_.insert(trial_point_.end(), blocks[2], blocks[2] + state_size_);
    if (trial_point_ == point_) return true;
    point_.clear();
    const UncoupledModel<double> model = ModelOf(blocks[0], *blocks[1]);
    if (!Simulate(model, StateFromBlock(window_.output, blocks[2]))) return false;
    const double inertia = model.inertia;
    AccumulateSamples(inertia);
    const int num_continuity = num_residuals() - num_columns_ - 1;
    const int last = simulation_.num_outputs() - 1;
    for (int k = 0; k < num_continuity; ++k) {
      const double scale = 1.0 / window_.continuity_sigma;
      const auto& values = k == 0 ? scratch_->velocity : scratch_->position;
      reached_[k] = scale * values[last];
      jacobian_.row(num_columns_ + 1 + k) = scale * Derivatives(last, k == 0, inertia);
    }
    point_ = trial_point_;
    return true;
  }

  bool Simulate(const UncoupledModel<double>& model, const InitialState& state) const {
    const size_t n = simulation_.num_outputs();
    const bool with_position = window_.output == FittedOutput::kPosition;
    if (scratch_->velocity.size() < n) {
      scratch_->velocity.resize(n);
      scratch_->velocity_sensitivity.resize(n * Simulation::kNumSensitivities);
    }
    if (with_position && scratch_->position.size() < n) {
      scratch_->position.resize(n);
      scratch_->position_sensitivity.resize(n * Simulation::kNumSensitivities);
    }
    const auto first = [](std::vector<double>& values, size_t count) {
      return std::span(values).first(count);
    };
    const size_t num_positions = with_position ? n : 0;
    return simulation_.RunWithSensitivities(
        model,
        state,
        first(scratch_->velocity, n),
        first(scratch_->position, num_positions),
        first(scratch_->velocity_sensitivity, n * Simulation::kNumSensitivities),
        first(scratch_->position_sensitivity, num_positions * Simulation::kNumSensitivities));
  }

  // Derivatives of one output by the parameters (inertia by its logarithm) and the initial state.
  Row Derivatives(int output, bool of_velocity, double inertia) const {
    const auto& all = of_velocity ? scratch_->velocity_sensitivity : scratch_->position_sensitivity;
    const double* const sensitivity =
        &all[static_cast<size_t>(output) * Simulation::kNumSensitivities];
    Row row;
    row << inertia * sensitivity[kInertia], sensitivity[kQuadraticDamping],
        sensitivity[kLinearDamping], sensitivity[kBuoyancy], sensitivity[kInitialVelocity],
        of_velocity ? 0.0 : 1.0;
    return row;
  }

  // Gram matrix of (J r) over the samples, J by the parameters and the initial state. The lower
  // triangle; kColumns: of J.
  template <int kColumns>
  auto SampleGram() const {
    const bool is_velocity = window_.output == FittedOutput::kVelocity;
    const auto& measured = is_velocity ? window_.segment->velocity : window_.segment->position;
    const auto& simulated = is_velocity ? scratch_->velocity : scratch_->position;
    const auto& all = is_velocity ? scratch_->velocity_sensitivity : scratch_->position_sensitivity;
    const double* sensitivity = all.data();
    double sums[kColumns + 1][kColumns + 1] = {};
    for (size_t i = window_.begin; i < window_.end;
         ++i, sensitivity += Simulation::kNumSensitivities) {
      const double miss = simulated[i - window_.begin] - measured[i];
      const RootHuber residual = RootHuber::Of(miss / window_.sigma, window_.huber_k);
      double row[kColumns + 1];
      for (int j = 0; j < Simulation::kNumSensitivities; ++j)
        row[j] = residual.derivative * sensitivity[j];
      if (kColumns > Simulation::kNumSensitivities)
        row[Simulation::kNumSensitivities] = residual.derivative;
      row[kColumns] = window_.sigma * residual.value;
      for (int j = 0; j <= kColumns; ++j) {
        for (int k = 0; k <= j; ++k) sums[j][k] += row[j] * row[k];
      }
    }
    Eigen::Matrix<double, kColumns + 1, kColumns + 1> gram;
    for (int j = 0; j <= kColumns; ++j) {
      for (int k = 0; k <= j; ++k) gram(j, k) = gram(k, j) = sums[j][k];
    }
    return gram;
  }

  // The samples' rows, compressed; docs/output_error.md (9).
  void AccumulateSamples(double inertia) const {
    Eigen::MatrixXd gram;
    if (state_size_ == 1) {
      gram = SampleGram<kNumParameters + 1>();
    } else {
      gram = SampleGram<kNumParameters + 2>();
    }
    gram /= window_.sigma * window_.sigma;
    gram.row(kInertia) *= inertia;
    gram.col(kInertia) *= inertia;
    const int n = num_columns_;
    const Eigen::MatrixXd JtJ = gram.topLeftCorner(n, n);
    const Eigen::VectorXd Jtr = gram.col(n).head(n);
    const double rtr = gram(n, n);
    // J'J = V L V': R = L^1/2 V' and q = L^-1/2 V' J'r, on columns of unit length. A direction that
    // leaves no trace has no part in J'r either.
    const Eigen::VectorXd scale =
        JtJ.diagonal().cwiseSqrt().cwiseMax(std::numeric_limits<double>::min());
    const Eigen::VectorXd unscale = scale.cwiseInverse();
    const SymmetricEigen eigen = EigenOf(unscale.asDiagonal() * JtJ * unscale.asDiagonal());
    const Eigen::VectorXd root = eigen.values.cwiseMax(0.0).cwiseSqrt();
    const Eigen::VectorXd projected = eigen.vectors.transpose() * unscale.asDiagonal() * Jtr;
    residuals_.setZero(n + 1);
    for (int k = 0; k < n; ++k) {
      if (root[k] > 1e-8) residuals_[k] = projected[k] / root[k];
    }
    residuals_[n] = std::sqrt(std::max(0.0, rtr - residuals_.squaredNorm()));
    jacobian_.setZero(num_residuals(), kMostColumns);
    jacobian_.topLeftCorner(n, n) =
        root.asDiagonal() * eigen.vectors.transpose() * scale.asDiagonal();
  }

  const ShootingWindow window_;
  const int state_size_;
  const int num_columns_;  // of the parameters and the initial state
  const Simulation simulation_;
  const std::shared_ptr<SimulationScratch> scratch_;

  // The linearisation at point_.
  mutable std::vector<double> point_, trial_point_;
  mutable Eigen::VectorXd residuals_;
  mutable std::array<double, 2> reached_ = {};
  mutable Eigen::Matrix<double, Eigen::Dynamic, kMostColumns> jacobian_;
};

}  // namespace

VehicleBlock BlockOf(const UncoupledModel<double>& model) {
  return {std::log(model.inertia), model.quadratic_damping, model.linear_damping};
}

UncoupledModel<double> ModelOf(const double* vehicle, double buoyancy) {
  return {
      std::exp(vehicle[kInertia]), vehicle[kQuadraticDamping], vehicle[kLinearDamping], buoyancy};
}

std::unique_ptr<ceres::CostFunction> MakeWindowCost(const ShootingWindow& window,
                                                    std::shared_ptr<SimulationScratch> scratch) {
  CHECK_LT(window.begin, window.end);
  CHECK_LE(window.end + (window.continuity_sigma > 0.0 ? 1 : 0), window.segment->time.size());
  return std::make_unique<WindowCost>(window, std::move(scratch));
}

std::vector<double> WindowMisses(const ShootingWindow& window,
                                 const UncoupledModel<double>& model,
                                 const InitialState& state) {
  const bool is_velocity = window.output == FittedOutput::kVelocity;
  const Simulation simulation(window.segment->command, OutputTimes(window));
  std::vector<double> velocity(simulation.num_outputs());
  std::vector<double> position(is_velocity ? 0 : velocity.size());
  if (!simulation.Run(model, state, velocity, position)) return {};
  std::vector<double> misses = is_velocity ? velocity : position;
  const auto& measured = is_velocity ? window.segment->velocity : window.segment->position;
  misses.resize(window.end - window.begin);
  for (size_t i = 0; i < misses.size(); ++i) misses[i] -= measured[window.begin + i];
  return misses;
}

}  // namespace fathom
