// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/problem/linear_joint.h"

#include <cmath>

#include <Eigen/Dense>

namespace fathom {

bool IsResponse(int column) {
  return column >= kResponseColumns && column < kClockColumn &&
         (column - kResponseColumns) % kResponseTerms != 0;
}

int HeldSlot(int column) { return (column - kResponseColumns) / kResponseTerms; }

namespace {

double StdOf(const GlobalsPrior& prior,
             const ProcessSet& processes,
             const LinearRun& run,
             int column) {
  if (!IsResponse(column)) return prior.std[column];
  const double std = processes.response_std[HeldSlot(column)];
  return std > 0.0 ? std : NoResponseStd(run.response[column - kResponseColumns]);
}

// Changes the block of the setup in H so that it has this information once all other columns are
// eliminated. `columns` of H's first run.
void ReplaceSetup(const std::vector<int>& columns,
                  const SetupInformation& information,
                  Eigen::MatrixXd* H) {
  std::vector<int> setup, others, wanted;
  for (size_t c = 0; c < columns.size(); ++c) {
    const bool is_setup = columns[c] >= kSizeColumn && columns[c] < kNumShared;
    (is_setup ? setup : others).push_back(static_cast<int>(c));
    if (is_setup) wanted.push_back(columns[c] - kSizeColumn);
  }
  for (int c = static_cast<int>(columns.size()); c < H->cols(); ++c) others.push_back(c);
  if (setup.empty()) return;
  const Eigen::MatrixXd cross = (*H)(others, setup);
  const Eigen::MatrixXd among = (*H)(others, others);
  const Eigen::VectorXd unscale = among.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = unscale.asDiagonal() * cross;
  const Eigen::LLT<Eigen::MatrixXd> llt(unscale.asDiagonal() * among * unscale.asDiagonal());
  if (llt.info() != Eigen::Success) return;  // what follows says so
  (*H)(setup, setup) = information(wanted, wanted) + scaled.transpose() * llt.solve(scaled);
}

}  // namespace

LinearJoint::LinearJoint(std::span<const LinearRun> runs,
                         std::span<const GlobalsPrior> priors,
                         const ProcessSet& processes,
                         int excited,
                         const SetupInformation* setup) {
  // Where each run's columns stand in the system of all of them.
  std::vector<std::vector<int>> place(runs.size());
  int size = 0;
  for (size_t r = 0; r < runs.size(); ++r) {
    columns_.emplace_back();
    for (int i = 0, num_shared = 0; i < kNumColumns; ++i) {
      const bool is_shared = i < kNumShared;
      if (StdOf(priors[is_shared ? 0 : r], processes, runs[r], i) == 0.0) continue;
      columns_[r].push_back(i);
      place[r].push_back(is_shared && r > 0 ? num_shared++ : size++);
    }
  }

  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(size);
  double constant = 0.0, log_determinant = 0.0, num_rows = 0.0;
  num_unknowns_ = size;
  smoothers_.reserve(runs.size());
  for (size_t r = 0; r < runs.size(); ++r) {
    smoothers_.emplace_back(runs[r], processes, excited, columns_[r]);
    const ChainSmoother& smoother = smoothers_.back();
    if (!smoother.is_positive_definite()) return;
    H(place[r], place[r]) += smoother.H();
    b(place[r]) += smoother.b();
    constant += smoother.constant();
    log_determinant += smoother.log_determinant();
    num_rows += runs[r].num_rows;
    num_unknowns_ += smoother.num_eliminated();
    for (size_t c = 0; c < columns_[r].size(); ++c) {
      const int column = columns_[r][c];
      if (column < kNumShared && r > 0) continue;  // its prior counts once
      double std = priors[r].std[column], offset = priors[r].offset[column];
      if (IsResponse(column)) {
        std = StdOf(priors[r], processes, runs[r], column);
        offset = runs[r].response[column - kResponseColumns];
        log_determinant += 2.0 * std::log(std);
      }
      if (!std::isfinite(std)) continue;
      const double precision = 1.0 / (std * std);
      H(place[r][c], place[r][c]) += precision;
      b[place[r][c]] += precision * offset;
      constant += 0.5 * precision * offset * offset;
    }
  }
  if (setup != nullptr) ReplaceSetup(columns_[0], *setup, &H);
  // On columns of unit length: units differ by orders of magnitude.
  const Eigen::VectorXd unscale = H.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::LLT<Eigen::MatrixXd> llt(unscale.asDiagonal() * H * unscale.asDiagonal());
  constexpr double kSmallestShare = 1e-7;  // of a column that the others cannot imitate
  if (llt.info() != Eigen::Success || !(llt.matrixLLT().diagonal().minCoeff() > kSmallestShare)) {
    return;
  }
  const Eigen::VectorXd g = -(unscale.asDiagonal() * llt.solve(unscale.asDiagonal() * b));
  Eigen::MatrixXd covariance = llt.solve(Eigen::MatrixXd::Identity(size, size));
  covariance = unscale.asDiagonal() * covariance * unscale.asDiagonal();
  for (int i = 0; i < size; ++i) {
    log_determinant += 2.0 * std::log(llt.matrixLLT()(i, i) / unscale[i]);
  }
  cost_ = constant + 0.5 * b.dot(g);
  log_likelihood_ = -cost_ - 0.5 * log_determinant - num_rows * std::log(processes.corner_sigma);
  is_usable_ = std::isfinite(log_likelihood_);
  for (size_t r = 0; r < runs.size(); ++r) {
    changes_.emplace_back(Eigen::VectorXd::Zero(kNumColumns));
    covariances_.emplace_back(Eigen::MatrixXd::Zero(kNumColumns, kNumColumns));
    changes_[r](columns_[r]) = g(place[r]);
    covariances_[r](columns_[r], columns_[r]) = covariance(place[r], place[r]);
  }
}

std::vector<ChainSmoother::State> LinearJoint::Deviations(size_t run) const {
  return smoothers_[run].Deviations(changes_[run](columns_[run]));
}

RunMoments LinearJoint::Moments(size_t run) const {
  return smoothers_[run].Moments(changes_[run](columns_[run]),
                                 covariances_[run](columns_[run], columns_[run]));
}

}  // namespace fathom
