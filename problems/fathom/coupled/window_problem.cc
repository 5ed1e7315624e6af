// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/window_problem.h"

#include "fathom/base/parallel_for.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace fathom {
namespace {

constexpr double kStartRidge = 1e-10;  // of a start's own squares

// Half the square of a residual; beyond `k` it counts linearly.
double HuberCost(double residual, double k) {
  const double size = std::abs(residual);
  return size <= k ? 0.5 * residual * residual : k * size - 0.5 * k * k;
}

}  // namespace

bool ResidualsIn(const WindowProblem& problem,
                 const WindowPoint& point,
                 std::size_t w,
                 bool with_derivatives,
                 WindowResiduals* residuals) {
  return ResidualsOf(problem.windows[w],
                     point.model,
                     point.starts[w],
                     problem.entries,
                     problem.channels,
                     problem.free,
                     with_derivatives,
                     residuals);
}

bool AllResiduals(const WindowProblem& problem,
                  const WindowPoint& point,
                  std::vector<WindowResiduals>* residuals) {
  residuals->assign(problem.windows.size(), {});
  std::atomic<bool> runs = true;
  ParallelFor(static_cast<int>(residuals->size()), [&](int w) {
    const auto window = static_cast<std::size_t>(w);
    if (runs && !ResidualsIn(problem, point, window, false, &(*residuals)[window])) runs = false;
  });
  return runs;
}

PhysicalBarrier BarrierIn(const WindowProblem& problem, const CoupledModel& model) {
  PhysicalBarrier barrier = BarrierAt(model, problem.entries, problem.body);
  AddPriors(model, problem.entries, problem.priors, &barrier);
  return barrier;
}

Eigen::MatrixXd OfPriors(const WindowProblem& problem, const CoupledModel& model) {
  const auto size = static_cast<Eigen::Index>(problem.entries.size());
  PhysicalBarrier of = {0.0, Eigen::VectorXd::Zero(size), Eigen::MatrixXd::Zero(size, size)};
  AddPriors(model, problem.entries, problem.priors, &of);
  return of.hessian;
}

double WeighRows(const ChannelWeight& weight, WindowResiduals::Piece* piece) {
  RowMajorRows& rows = piece->rows;
  weight.whitener.Apply(rows);
  double cost = 0.0;
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const double size = std::abs(rows(i, 0));
    cost += HuberCost(size, weight.huber_k);
    if (size > weight.huber_k) rows.row(i) *= std::sqrt(weight.huber_k / size);
  }
  return cost;
}

Eigen::LLT<Eigen::MatrixXd> StartSolver(const Eigen::MatrixXd& ss, double damping) {
  Eigen::MatrixXd damped = ss;
  damped.diagonal() *= 1.0 + damping + kStartRidge;
  const double largest = std::max(ss.diagonal().maxCoeff(), 1e-300);
  damped.diagonal().array() += 1e-14 * largest;
  return Eigen::LLT<Eigen::MatrixXd>(damped);
}

}  // namespace fathom
