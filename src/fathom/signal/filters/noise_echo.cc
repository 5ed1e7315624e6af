// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/filters/noise_echo.h"

#include <cmath>
#include <vector>

namespace fathom {
namespace {

// The recursion as a lattice. Of order j, from 0 to that of the noise:
struct Lattice {
  std::vector<Eigen::VectorXd> coefficients;  // of the predictor
  std::vector<double> reflections;            // from j to j + 1
  std::vector<double> scale;                  // its error over that of the full order
};

// By Levinson's recursion backwards.
Lattice LatticeOf(std::span<const double> coefficients) {
  const auto order = static_cast<int>(coefficients.size());
  Lattice lattice;
  lattice.coefficients.resize(order + 1);
  lattice.reflections.resize(order);
  lattice.scale.assign(order + 1, 1.0);
  lattice.coefficients[order] = Eigen::Map<const Eigen::VectorXd>(coefficients.data(), order);
  for (int j = order; j > 0; --j) {
    const Eigen::VectorXd& a = lattice.coefficients[j];
    const double reflection = a[j - 1], left = 1.0 - reflection * reflection;
    lattice.reflections[j - 1] = reflection;
    lattice.scale[j - 1] = lattice.scale[j] / std::sqrt(left);
    lattice.coefficients[j - 1] = (a.head(j - 1) + reflection * a.head(j - 1).reverse()) / left;
  }
  return lattice;
}

}  // namespace

// The state is that of the lattice, the backward prediction errors over their standard deviations:
// no step of it makes any state longer, so that its powers lose nothing to rounding where those of
// the recursion's own matrix do.
Eigen::MatrixXd EchoOf(std::span<const double> coefficients) {
  const auto order = static_cast<int>(coefficients.size());
  const Lattice lattice = LatticeOf(coefficients);
  Eigen::MatrixXd state = Eigen::MatrixXd::Zero(order, order);  // from the last rows
  Eigen::MatrixXd step = Eigen::MatrixXd::Zero(order, order);
  for (int j = 0; j < order; ++j) {
    const int own = order - 1 - j;
    state(j, own) = 1.0 / lattice.scale[j];
    state.row(j).segment(own + 1, j) = -lattice.coefficients[j].transpose() / lattice.scale[j];
  }
  for (int column = 0; column < order; ++column) {
    double forward = 0.0;  // error of the full order: nothing is new
    for (int j = order - 1; j >= 0; --j) {
      const double backward = j == column ? lattice.scale[j] : 0.0;
      forward += lattice.reflections[j] * backward;
      if (j + 1 < order) {
        step(j + 1, column) = (backward - lattice.reflections[j] * forward) / lattice.scale[j + 1];
      }
    }
    step(0, column) = forward / lattice.scale[0];
  }
  const Eigen::RowVectorXd next = lattice.scale[0] * step.row(0);
  Eigen::MatrixXd sum = next.transpose() * next;
  // Each turn doubles the rows that are summed up.
  constexpr int kMostTurns = 64;
  constexpr double kSmallest = 1e-17;
  for (int turn = 0; turn < kMostTurns; ++turn) {
    const Eigen::MatrixXd more = step.transpose() * sum * step;
    sum += more;
    if (!(more.trace() > kSmallest * sum.trace())) break;
    step = (step * step).eval();
  }
  return state.transpose() * sum * state;
}

}  // namespace fathom
