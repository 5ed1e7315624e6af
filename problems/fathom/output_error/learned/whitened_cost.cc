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
    mutable_parameter_block_sizes()->push_back(kNumParameters);
    mutable_parameter_block_sizes()->push_back(state_size_);
  }

  bool Evaluate(const double* const* parameters,
                double* residuals,
                double** jacobians) const override {
    if (!Linearise(parameters[0], parameters[1])) return false;
    Eigen::Map<Eigen::VectorXd>(residuals, num_residuals()) = run_.residual();
    if (jacobians == nullptr) return true;
    if (jacobians[0] != nullptr) {
      Eigen::Map<RowMajorMatrix> by_parameters(jacobians[0], num_residuals(), kNumParameters);
      by_parameters = run_.parameters();
      by_parameters.col(kInertia) *= std::exp(parameters[0][kInertia]);  // by its logarithm
    }
    if (jacobians[1] != nullptr) {
      Eigen::Map<RowMajorMatrix>(jacobians[1], num_residuals(), state_size_) = run_.state();
    }
    return true;
  }

 private:
  // Fills run_ at this point. Ceres asks for the residuals at a trial point and, if it is accepted,
  // for the Jacobian at the same point: simulate once and remember the point by its values.
  bool Linearise(const double* parameters, const double* state) const {
    std::vector<double> point(parameters, parameters + kNumParameters);
    point.insert(point.end(), state, state + state_size_);
    if (point == point_) return true;
    point_.clear();
    const UncoupledModel<double> model = {std::exp(parameters[kInertia]),
                                          parameters[kQuadraticDamping],
                                          parameters[kLinearDamping],
                                          parameters[kBuoyancy]};
    const InitialState initial = {state[0], state_size_ > 1 ? state[1] : 0.0};
    std::optional<BinnedRun> run = RunOverBins(model, initial, bins_);
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
