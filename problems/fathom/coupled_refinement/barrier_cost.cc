// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_refinement/barrier_cost.h"

#include "fathom/coupled/physical_barrier.h"
#include "fathom/solve/decompositions.h"
#include "fathom/vehicle/coupled/entry_value.h"

#include <cmath>

#include <ceres/cost_function.h>

namespace fathom {
namespace {

// Keeps the cost positive: mu log det of a vehicle of 10^6 kg in all DOFs is below 20.
constexpr double kLift = 100.0;
constexpr double kFlat = 1e-12;  // of the scaled curvature: a direction that the barrier ignores

class BarrierCost final : public ceres::CostFunction {
 public:
  BarrierCost(const CoupledFilm& film, const FilmUnknowns& unknowns)
      : film_(film),
        unknowns_(unknowns),
        size_(static_cast<int>(film.structure.entries.size())),
        num_shared_(static_cast<int>(unknowns.shared.size())) {
    set_num_residuals(size_ + 1);
    mutable_parameter_block_sizes()->push_back(num_shared_);
  }

  bool Evaluate(const double* const* parameters,
                double* residuals,
                double** jacobians) const override {
    CoupledModel model = unknowns_.model;
    for (int i = 0; i < size_; ++i) {
      SetValue(film_.structure.entries[static_cast<std::size_t>(i)], parameters[0][i], &model);
    }
    const PhysicalBarrier barrier = BarrierAt(model, film_.structure.entries, film_.body);
    if (!std::isfinite(barrier.cost)) return false;
    // H = S V D V' S with S the roots of its diagonal, and J = D^1/2 V' S, r = D^-1/2 V' S^-1 g.
    const Eigen::VectorXd diagonal = barrier.hessian.diagonal();
    const Eigen::VectorXd scale = (diagonal.array() > 0.0).select(diagonal.cwiseSqrt(), 1.0);
    const Eigen::VectorXd unscale = scale.cwiseInverse();
    const SymmetricEigen eigen =
        EigenOf(unscale.asDiagonal() * barrier.hessian * unscale.asDiagonal());
    const Eigen::VectorXd along =
        eigen.vectors.transpose() * (unscale.asDiagonal() * barrier.gradient);
    double squares = 0.0;
    for (int i = 0; i < size_; ++i) {
      const double curvature = eigen.values[i];
      residuals[i] = curvature > kFlat ? along[i] / std::sqrt(curvature) : 0.0;
      squares += residuals[i] * residuals[i];
    }
    const double left = 2.0 * (barrier.cost + kLift) - squares;
    if (!(left > 0.0)) return false;
    residuals[size_] = std::sqrt(left);
    if (jacobians == nullptr || jacobians[0] == nullptr) return true;
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> J(
        jacobians[0], size_ + 1, num_shared_);
    J.setZero();
    for (int i = 0; i < size_; ++i) {
      const double curvature = eigen.values[i];
      if (!(curvature > kFlat)) continue;
      J.row(i).head(size_) =
          std::sqrt(curvature) * eigen.vectors.col(i).transpose() * scale.asDiagonal();
    }
    return true;
  }

 private:
  const CoupledFilm& film_;
  const FilmUnknowns& unknowns_;
  const int size_, num_shared_;  // of the block; the entries come first
};

}  // namespace

std::unique_ptr<ceres::CostFunction> MakeBarrierCost(const CoupledFilm& film,
                                                     const FilmUnknowns& unknowns) {
  return std::make_unique<BarrierCost>(film, unknowns);
}

}  // namespace fathom
