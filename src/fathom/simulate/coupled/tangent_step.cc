// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/tangent_step.h"

namespace fathom {
namespace {

// Of the columns of `left`, what each column of `right` makes; both small, so unrolled.
template <typename Left, typename Right, typename Out>
void Combine(const Left& left, const Right& right, Out&& out) {
  for (Eigen::Index j = 0; j < right.cols(); ++j) {
    out.col(j) = left.col(0) * right(0, j) + left.col(1) * right(1, j) + left.col(2) * right(2, j) +
                 left.col(3) * right(3, j) + left.col(4) * right(4, j) + left.col(5) * right(5, j);
  }
}

}  // namespace

// From the last stage to the first. With y = (s, s_turn), k_i = F_i (y + c_i h k_(i-1)) + f_i, and
// the end y + sum w_i k_i, the end's derivative by k_i is D_i = w_i + c_(i+1) h T_(i+1), and by the
// y within k_i it is T_i = D_i F_i; the position takes its w_i P_i there.
void TangentStep::Set(std::span<const TangentLaw, 4> laws, const Matrix6& inverse, double h) {
  constexpr double kAhead[4] = {0.5, 0.5, 1.0, 0.0};  // c of the stage after
  const double weights[4] = {h / 6.0, h / 3.0, h / 3.0, h / 6.0};
  Eigen::Matrix<double, 12, 9> by_stage, by_rate;
  by_stage.setZero();
  by_tangent.setIdentity();
  for (int i = 3; i >= 0; --i) {
    const TangentLaw& law = laws[static_cast<std::size_t>(i)];
    by_rate = kAhead[i] * h * by_stage;
    by_rate.diagonal().array() += weights[i];
    Combine(by_rate.leftCols<6>(), inverse, by_force[i]);
    Combine(by_force[i], law.force, by_stage);
    by_stage.middleCols<3>(3) += by_rate.rightCols<3>();
    for (Eigen::Index j = 0; j < 3; ++j) {
      by_stage.col(6 + j) += by_rate.col(6) * law.turn(0, j) + by_rate.col(7) * law.turn(1, j) +
                             by_rate.col(8) * law.turn(2, j);
    }
    by_stage.bottomRows<3>() += weights[i] * law.position;
    by_tangent += by_stage;
  }
}

}  // namespace fathom
