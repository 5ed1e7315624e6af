// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/problem/chain_smoother.h"

#include "fathom/joint_refinement/problem/linear_cost.h"

#include <cmath>

#include <Eigen/Dense>

namespace fathom {
struct ChainSmoother::Step {
  struct OfCoordinate {
    Eigen::Matrix2d here;   // Phi' Q^-1 Phi, on the state before
    Eigen::Matrix2d there;  // Q^-1
    double log_det_Q;
  };
  std::array<OfCoordinate, 6> of;
};

// What the frames so far leave for the next one: 1/2 s' A s + s' (B g + b).
struct ChainSmoother::Equations {
  Square A = Square::Zero();
  Border B;
  State b = State::Zero();

  explicit Equations(Eigen::Index num_columns) : B(Border::Zero(12, num_columns)) {}
};

ChainSmoother::ChainSmoother(const LinearSegment& segment,
                             const ProcessSet& processes,
                             int excited,
                             const std::vector<int>& columns)
    : segment_(segment), num_columns_(static_cast<Eigen::Index>(columns.size())) {
  const double weight = 1.0 / (processes.corner_sigma * processes.corner_sigma);
  std::array<SecondOrderProcess, 6> process;
  for (int i = 0; i < 6; ++i) {
    process[i] = processes.Of(i, excited);
    is_present_[i] = process[i].IsPresent();
  }
  const std::vector<Step> steps = LayOutSteps(process);
  const size_t n = segment.frames.size();
  eliminated_.resize(n);
  V_.resize(12, static_cast<Eigen::Index>(n) * num_columns_);
  H_ = weight * segment.JgJg(columns, columns);
  b_ = weight * segment.Jgr(columns);
  constant_ = 0.5 * weight * segment.rr;
  Equations equations = BeforeFirst(process, excited);
  Border W(12, num_columns_);
  for (size_t k = 0; k < n; ++k) {
    const bool is_last = k + 1 == n;
    const Step* const step = is_last ? nullptr : &steps[segment.duration_after[k]];
    AddFrame(segment.frames[k], weight, columns, step, &equations);
    if (!Eliminate(equations, k, &W)) {
      is_positive_definite_ = false;
      return;
    }
    if (!is_last) LeaveToNext(k, *step, W, &equations);
  }
}

std::vector<ChainSmoother::Step> ChainSmoother::LayOutSteps(
    const std::array<SecondOrderProcess, 6>& process) {
  std::vector<Step> steps(segment_.durations.size());
  couplings_.resize(steps.size());
  for (size_t s = 0; s < steps.size(); ++s) {
    for (int i = 0; i < 6; ++i) {
      if (!is_present_[i]) continue;
      const Transition t = process[i].Over(segment_.durations[s]);
      const Eigen::Matrix2d WPhi = t.whitener * t.Phi;
      steps[s].of[i] = {WPhi.transpose() * WPhi, t.whitener.transpose() * t.whitener, t.log_det_Q};
      couplings_[s][i] = -WPhi.transpose() * t.whitener;  // -Phi' Q^-1
    }
  }
  return steps;
}

ChainSmoother::Equations ChainSmoother::BeforeFirst(
    const std::array<SecondOrderProcess, 6>& process, int excited) {
  Equations equations(num_columns_);
  for (int i = 0; i < 6; ++i) {
    if (!is_present_[i]) continue;
    const Eigen::Matrix2d P0 =
        i == excited ? Eigen::Matrix2d(kStartStd * kStartStd * Eigen::Matrix2d::Identity())
                     : process[i].StationaryCovariance();
    equations.A.block<2, 2>(2 * i, 2 * i) = P0.inverse();
    log_determinant_ += std::log(P0.determinant());
    num_eliminated_ += 2 * static_cast<int>(segment_.frames.size());
  }
  return equations;
}

void ChainSmoother::AddFrame(const LinearFrame& frame,
                             double weight,
                             const std::vector<int>& columns,
                             const Step* step,
                             Equations* equations) const {
  auto& [A, B, b] = *equations;
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
    if (step != nullptr) A.block<2, 2>(2 * i, 2 * i) += step->of[i].here;
  }
}

bool ChainSmoother::Eliminate(const Equations& equations, size_t k, Border* W) {
  const auto& [A, B, b] = equations;
  const Eigen::LLT<Square> llt(A);
  if (llt.info() != Eigen::Success) return false;
  Eliminated& e = eliminated_[k];
  for (int i = 0; i < 12; ++i) log_determinant_ += 2.0 * std::log(llt.matrixLLT()(i, i));
  e.S_inverse.setIdentity();
  llt.solveInPlace(e.S_inverse);
  W->noalias() = e.S_inverse * B;
  V_.middleCols(static_cast<Eigen::Index>(k) * num_columns_, num_columns_) = *W;
  e.y.noalias() = e.S_inverse * b;
  H_.noalias() -= B.transpose() * *W;
  b_.noalias() -= B.transpose() * e.y;
  constant_ -= 0.5 * b.dot(e.y);
  return true;
}

void ChainSmoother::LeaveToNext(size_t k, const Step& step, const Border& W, Equations* left) {
  const Coupling& C = couplings_[segment_.duration_after[k]];
  const Eliminated& e = eliminated_[k];
  Square U = Square::Zero();  // S^-1 C
  left->A.setZero();
  left->B.setZero();
  left->b.setZero();
  for (int i = 0; i < 6; ++i) {
    if (!is_present_[i]) continue;
    U.middleCols<2>(2 * i).noalias() = e.S_inverse.middleCols<2>(2 * i) * C[i];
    log_determinant_ += step.of[i].log_det_Q;
  }
  for (int i = 0; i < 6; ++i) {
    if (!is_present_[i]) continue;
    const Eigen::Matrix2d cross = C[i].transpose();
    left->A.middleRows<2>(2 * i).noalias() -= cross * U.middleRows<2>(2 * i);
    left->A.block<2, 2>(2 * i, 2 * i) += step.of[i].there;
    left->B.middleRows<2>(2 * i).noalias() -= cross * W.middleRows<2>(2 * i);
    left->b.segment<2>(2 * i) -= cross * e.y.segment<2>(2 * i);
  }
}

template <typename Matrix>
Matrix ChainSmoother::Coupled(size_t k, const Matrix& X) const {
  const Coupling& C = couplings_[segment_.duration_after[k]];
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

SegmentMoments ChainSmoother::Moments(const Eigen::VectorXd& g,
                                      const Eigen::MatrixXd& covariance) const {
  SegmentMoments moments;
  for (auto& steps : moments.steps) steps.resize(segment_.durations.size());
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
      if (k > 0) moments.steps[i][segment_.duration_after[k - 1]].after += second;
      if (is_last) continue;
      StepMoments& step = moments.steps[i][segment_.duration_after[k]];
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
