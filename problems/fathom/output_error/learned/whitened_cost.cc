// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/learned/whitened_cost.h"

#include "fathom/output_error/learned/binned_run.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <ceres/cost_function.h>

namespace fathom {
namespace {

class WhitenedCost final : public ceres::CostFunction {
 public:
  WhitenedCost(const BinnedSegment& bins, const Whitener& whitener)
      : bins_(bins), whitener_(whitener), state_size_(StateSize(bins.output)) {
    set_num_residuals(bins.size());
    mutable_parameter_block_sizes()->push_back(kBuoyancy);
    mutable_parameter_block_sizes()->push_back(1);
    mutable_parameter_block_sizes()->push_back(state_size_);
  }

  bool Evaluate(const double* const* parameters,
                double* residuals,
                double** jacobians) const override {
    if (!Linearise(parameters)) return false;
    Eigen::Map<Eigen::VectorXd>(residuals, num_residuals()) = run_.residual();
    if (jacobians == nullptr) return true;
    if (jacobians[0] != nullptr) {
      Eigen::Map<RowMajorMatrix> by_vehicle(jacobians[0], num_residuals(), kBuoyancy);
      by_vehicle = run_.parameters().leftCols(kBuoyancy);
      by_vehicle.col(kInertia) *= std::exp(parameters[0][kInertia]);  // by its logarithm
    }
    if (jacobians[1] != nullptr) {
      Eigen::Map<Eigen::VectorXd>(jacobians[1], num_residuals()) = run_.parameters().col(kBuoyancy);
    }
    if (jacobians[2] != nullptr) {
      Eigen::Map<RowMajorMatrix>(jacobians[2], num_residuals(), state_size_) = run_.state();
    }
    return true;
  }

 private:
  // Fills run_ at this point. Ceres asks for the residuals at a trial point and, if it is accepted,
  // for the Jacobian at the same point: simulate once and remember the point by its values.
  bool Linearise(const double* const* blocks) const {
    const double* const state = blocks[2];
    std::vector<double> point(blocks[0], blocks[0] + kBuoyancy);
    point.push_back(*blocks[1]);
    point.insert(point.end(), state, state + state_size_);
    if (point == point_) return true;
    point_.clear();
    const InitialState initial = {state[0], state_size_ > 1 ? state[1] : 0.0};
    std::optional<BinnedRun> run = RunOverBins(ModelOf(blocks[0], *blocks[1]), initial, bins_);
    if (!run) return false;
    run_ = *std::move(run);
    whitener_.Apply(run_.columns, run_.columns);
    point_ = std::move(point);
    return true;
  }

  const BinnedSegment& bins_;
  const Whitener& whitener_;
  const int state_size_;

  mutable std::vector<double> point_;
  mutable BinnedRun run_;  // whitened, at point_
};

}  // namespace

std::unique_ptr<ceres::CostFunction> MakeWhitenedCost(const BinnedSegment& bins,
                                                      const Whitener& whitener) {
  return std::make_unique<WhitenedCost>(bins, whitener);
}

}  // namespace fathom
