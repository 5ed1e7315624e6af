// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/problem/chain_smoother.h"

#include "fathom/joint_refinement/problem/linear_cost.h"

#include <cmath>

#include <Eigen/Dense>

namespace fathom {
namespace {

struct CoordinateStep {
  Eigen::Matrix2d here;   // Phi' Q^-1 Phi, on the state before
  Eigen::Matrix2d there;  // Q^-1
  double log_det_Q;
};

}  // namespace

ChainSmoother::ChainSmoother(const LinearRun& run,
                             const ProcessSet& processes,
                             int excited,
                             const std::vector<int>& columns)
    : run_(run), num_columns_(static_cast<Eigen::Index>(columns.size())) {
  const double weight = 1.0 / (processes.corner_sigma * processes.corner_sigma);
  std::array<SecondOrderProcess, 6> process;
  for (int i = 0; i < 6; ++i) {
    process[i] = processes.Of(i, excited);
    is_present_[i] = process[i].IsPresent();
  }
  std::vector<std::array<CoordinateStep, 6>> steps(run.durations.size());
  couplings_.resize(steps.size());
  for (size_t s = 0; s < steps.size(); ++s) {
    for (int i = 0; i < 6; ++i) {
      if (!is_present_[i]) continue;
      const Transition t = process[i].Over(run.durations[s]);
      const Eigen::Matrix2d WPhi = t.whitener * t.Phi;
      steps[s][i] = {WPhi.transpose() * WPhi, t.whitener.transpose() * t.whitener, t.log_det_Q};
      couplings_[s][i] = -WPhi.transpose() * t.whitener;  // -Phi' Q^-1
    }
  }

  const size_t n = run.frames.size();
  eliminated_.resize(n);
  V_.resize(12, static_cast<Eigen::Index>(n) * num_columns_);
  H_ = weight * run.JgJg(columns, columns);
  b_ = weight * run.Jgr(columns);
  constant_ = 0.5 * weight * run.rr;
  // What the frames so far leave for the next one.
  Square left_A = Square::Zero();
  Border left_B = Border::Zero(12, num_columns_);
  State left_b = State::Zero();
  for (int i = 0; i < 6; ++i) {
    if (!is_present_[i]) continue;
    const Eigen::Matrix2d P0 =
        i == excited ? Eigen::Matrix2d(kStartStd * kStartStd * Eigen::Matrix2d::Identity())
                     : process[i].StationaryCovariance();
    left_A.block<2, 2>(2 * i, 2 * i) = P0.inverse();
    log_determinant_ += std::log(P0.determinant());
    num_eliminated_ += 2 * static_cast<int>(n);
  }
  Border W(12, num_columns_);
  Square U;  // S^-1 C
  for (size_t k = 0; k < n; ++k) {
    const LinearFrame& frame = run.frames[k];
    const bool is_last = k + 1 == n;
    const auto* const step = is_last ? nullptr : &steps[run.duration_after[k]];
    const Coupling* const C = is_last ? nullptr : &couplings_[run.duration_after[k]];
    Square A = left_A;
    Border B = left_B;
    State b = left_b;
    for (int i = 0; i < 6; ++i) {
      if (!is_present_[i]) {
        A(2 * i, 2 * i) = A(2 * i + 1, 2 * i + 1) = 1.0;
        continue;
      }
      for (int j = 0; j < 6; ++j) {
        if (is_present_[j]) A(2 * i, 2 * j) += weight * frame.JdJd(i, j);
      }
      for (Eigen::Index c = 0; c < num_columns_; ++c) {
        B(2 * i, c) += weight * frame.JdJg(i, columns[c]);
      }
      b[2 * i] += weight * frame.Jdr[i];
      if (!is_last) A.block<2, 2>(2 * i, 2 * i) += (*step)[i].here;
    }
    const Eigen::LLT<Square> llt(A);
    if (llt.info() != Eigen::Success) {
      is_positive_definite_ = false;
      return;
    }
    Eliminated& e = eliminated_[k];
    for (int i = 0; i < 12; ++i) log_determinant_ += 2.0 * std::log(llt.matrixLLT()(i, i));
    e.S_inverse.setIdentity();
    llt.solveInPlace(e.S_inverse);
    W.noalias() = e.S_inverse * B;
    V_.middleCols(static_cast<Eigen::Index>(k) * num_columns_, num_columns_) = W;
    e.y.noalias() = e.S_inverse * b;
    H_.noalias() -= B.transpose() * W;
    b_.noalias() -= B.transpose() * e.y;
    constant_ -= 0.5 * b.dot(e.y);
    U.setZero();
    left_A.setZero();
    left_B.setZero();
    left_b.setZero();
    if (is_last) continue;
    for (int i = 0; i < 6; ++i) {
      if (!is_present_[i]) continue;
      U.middleCols<2>(2 * i).noalias() = e.S_inverse.middleCols<2>(2 * i) * (*C)[i];
      log_determinant_ += (*step)[i].log_det_Q;
    }
    for (int i = 0; i < 6; ++i) {
      if (!is_present_[i]) continue;
      const Eigen::Matrix2d cross = (*C)[i].transpose();
      left_A.middleRows<2>(2 * i).noalias() -= cross * U.middleRows<2>(2 * i);
      left_A.block<2, 2>(2 * i, 2 * i) += (*step)[i].there;
      left_B.middleRows<2>(2 * i).noalias() -= cross * W.middleRows<2>(2 * i);
      left_b.segment<2>(2 * i) -= cross * e.y.segment<2>(2 * i);
    }
  }
}

template <typename Matrix>
Matrix ChainSmoother::Coupled(size_t k, const Matrix& X) const {
  const Coupling& C = couplings_[run_.duration_after[k]];
  Matrix product = Matrix::Zero(12, X.cols());
  for (int i = 0; i < 6; ++i) {
    if (!is_present_[i]) continue;
    product.template middleRows<2>(2 * i).noalias() = C[i] * X.template middleRows<2>(2 * i);
  }
  return product;
}

std::vector<ChainSmoother::State> ChainSmoother::Deviations(const Eigen::VectorXd& g) const {
  std::vector<State> states(eliminated_.size());
  for (size_t k = eliminated_.size(); k-- > 0;) {
    const Eliminated& e = eliminated_[k];
    states[k] = -e.y - V(k) * g;
    if (k + 1 < eliminated_.size()) states[k] -= e.S_inverse * Coupled(k, states[k + 1]);
  }
  return states;
}

void ChainSmoother::ForEachFrame(
    const std::function<void(size_t, const Square&, const Border&)>& visit) const {
  Square P = Square::Zero();
  Border G = Border::Zero(12, num_columns_);
  for (size_t k = eliminated_.size(); k-- > 0;) {
    const Eliminated& e = eliminated_[k];
    const bool is_last = k + 1 == eliminated_.size();
    if (is_last) {
      P = e.S_inverse;
      G = -V(k);
    } else {
      const Square half = e.S_inverse * Coupled(k, P);  // U P, with U = S^-1 C
      const Square from_next = e.S_inverse * Coupled(k, Square(half.transpose()));
      const Border G_next = Coupled(k, G);
      P = e.S_inverse + from_next;
      G = -V(k);
      G.noalias() -= e.S_inverse * G_next;
    }
    for (int i = 0; i < 6; ++i) {
      if (is_present_[i]) continue;  // it stays on its mean
      P.middleRows<2>(2 * i).setZero();
      P.middleCols<2>(2 * i).setZero();
    }
    visit(k, P, G);
  }
}

RunMoments ChainSmoother::Moments(const Eigen::VectorXd& g,
                                  const Eigen::MatrixXd& covariance) const {
  RunMoments moments;
  for (auto& steps : moments.steps) steps.resize(run_.durations.size());
  const Eigen::MatrixXd root = Eigen::LLT<Eigen::MatrixXd>(covariance).matrixL();
  State next = State::Zero();
  Square P_next = Square::Zero(), P, P_across;
  // How the deviations move with the columns' standardised uncertainty.
  Border Z(12, num_columns_), Z_next = Border::Zero(12, num_columns_);
  for (size_t k = eliminated_.size(); k-- > 0;) {
    const Eliminated& e = eliminated_[k];
    const bool is_last = k + 1 == eliminated_.size();
    State s = -e.y - V(k) * g;
    Z.noalias() = -V(k) * root.triangularView<Eigen::Lower>();
    P = e.S_inverse;
    P_across.setZero();  // covariance of the next state and this one
    if (!is_last) {
      // With U = S^-1 C.
      s -= e.S_inverse * Coupled(k, next);
      P_across.noalias() = -Coupled(k, P_next).transpose() * e.S_inverse;  // -P U'
      P.noalias() -= e.S_inverse * Coupled(k, P_across);
      Z.noalias() -= e.S_inverse * Coupled(k, Z_next);
    }
    for (int i = 0; i < 6; ++i) {
      if (!is_present_[i]) continue;
      const auto own = s.segment<2>(2 * i);
      const auto rows = Z.middleRows<2>(2 * i);
      const Eigen::Matrix2d second =
          own * own.transpose() + P.block<2, 2>(2 * i, 2 * i) + rows * rows.transpose();
      if (k == 0) moments.first[i] = second;
      if (k > 0) moments.steps[i][run_.duration_after[k - 1]].after += second;
      if (is_last) continue;
      StepMoments& step = moments.steps[i][run_.duration_after[k]];
      step.before += second;
      step.across += next.segment<2>(2 * i) * own.transpose() + P_across.block<2, 2>(2 * i, 2 * i) +
                     Z_next.middleRows<2>(2 * i) * rows.transpose();
      step.count += 1.0;
    }
    next = s;
    P_next = P;
    Z_next = Z;
  }
  return moments;
}

}  // namespace fathom
