// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/problem/linear_joint.h"

#include <cmath>
#include <optional>

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
             const LinearSegment& segment,
             int column) {
  if (!IsResponse(column)) return prior.std[column];
  const double std = processes.response_std[HeldSlot(column)];
  return std > 0.0 ? std : NoResponseStd(segment.response[column - kResponseColumns]);
}

// Changes the block of the setup in H so that it has this information once all other columns are
// eliminated. `columns` of H's first segment.
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

// The solution of a system that is of full rank.
struct Solved {
  Eigen::VectorXd g;
  Eigen::MatrixXd covariance;
  double log_determinant = 0.0;  // with what there was before
};

// On columns of unit length: units differ by orders of magnitude. Nothing if some column leaves no
// trace of its own.
std::optional<Solved> Solve(const Eigen::MatrixXd& H,
                            const Eigen::VectorXd& b,
                            double log_determinant) {
  const Eigen::VectorXd unscale = H.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::LLT<Eigen::MatrixXd> llt(unscale.asDiagonal() * H * unscale.asDiagonal());
  constexpr double kSmallestShare = 1e-7;  // of a column that the others cannot imitate
  if (llt.info() != Eigen::Success || !(llt.matrixLLT().diagonal().minCoeff() > kSmallestShare)) {
    return std::nullopt;
  }
  Solved solved;
  solved.g = -(unscale.asDiagonal() * llt.solve(unscale.asDiagonal() * b));
  solved.covariance = llt.solve(Eigen::MatrixXd::Identity(H.rows(), H.cols()));
  solved.covariance = unscale.asDiagonal() * solved.covariance * unscale.asDiagonal();
  solved.log_determinant = log_determinant;
  for (Eigen::Index i = 0; i < H.rows(); ++i) {
    solved.log_determinant += 2.0 * std::log(llt.matrixLLT()(i, i) / unscale[i]);
  }
  return solved;
}

}  // namespace

// What is left of all segments once their deviations are eliminated, over the columns of all.
struct LinearJoint::System {
  std::vector<std::vector<int>> place;  // of each segment's columns
  Eigen::MatrixXd H;
  Eigen::VectorXd b;
  double constant = 0.0, log_determinant = 0.0, num_rows = 0.0;
};

LinearJoint::LinearJoint(std::span<const LinearSegment> segments,
                         std::span<const GlobalsPrior> priors,
                         const ProcessSet& processes,
                         int excited,
                         const SetupInformation* setup) {
  System system = LayOutColumns(segments, priors, processes);
  smoothers_.reserve(segments.size());
  for (size_t r = 0; r < segments.size(); ++r) {
    smoothers_.emplace_back(segments[r], processes, excited, columns_[r]);
    const ChainSmoother& smoother = smoothers_.back();
    if (!smoother.is_positive_definite()) return;
    const std::vector<int>& place = system.place[r];
    system.H(place, place) += smoother.H();
    system.b(place) += smoother.b();
    system.constant += smoother.constant();
    system.log_determinant += smoother.log_determinant();
    system.num_rows += segments[r].num_rows;
    num_unknowns_ += smoother.num_eliminated();
    AddPriors(segments[r], priors[r], processes, r, &system);
  }
  if (setup != nullptr) ReplaceSetup(columns_[0], *setup, &system.H);
  const std::optional<Solved> solved = Solve(system.H, system.b, system.log_determinant);
  if (!solved) return;
  cost_ = system.constant + 0.5 * system.b.dot(solved->g);
  log_likelihood_ =
      -cost_ - 0.5 * solved->log_determinant - system.num_rows * std::log(processes.corner_sigma);
  is_usable_ = std::isfinite(log_likelihood_);
  for (size_t r = 0; r < segments.size(); ++r) {
    const std::vector<int>& place = system.place[r];
    changes_.emplace_back(Eigen::VectorXd::Zero(kNumColumns));
    covariances_.emplace_back(Eigen::MatrixXd::Zero(kNumColumns, kNumColumns));
    changes_[r](columns_[r]) = solved->g(place);
    covariances_[r](columns_[r], columns_[r]) = solved->covariance(place, place);
  }
}

LinearJoint::System LinearJoint::LayOutColumns(std::span<const LinearSegment> segments,
                                               std::span<const GlobalsPrior> priors,
                                               const ProcessSet& processes) {
  System system;
  system.place.resize(segments.size());
  int size = 0;
  for (size_t r = 0; r < segments.size(); ++r) {
    columns_.emplace_back();
    for (int i = 0, num_shared = 0; i < kNumColumns; ++i) {
      const bool is_shared = i < kNumShared;
      if (StdOf(priors[is_shared ? 0 : r], processes, segments[r], i) == 0.0) continue;
      columns_[r].push_back(i);
      system.place[r].push_back(is_shared && r > 0 ? num_shared++ : size++);
    }
  }
  system.H = Eigen::MatrixXd::Zero(size, size);
  system.b = Eigen::VectorXd::Zero(size);
  num_unknowns_ = size;
  return system;
}

void LinearJoint::AddPriors(const LinearSegment& segment,
                            const GlobalsPrior& prior,
                            const ProcessSet& processes,
                            size_t r,
                            System* system) const {
  for (size_t c = 0; c < columns_[r].size(); ++c) {
    const int column = columns_[r][c], place = system->place[r][c];
    if (column < kNumShared && r > 0) continue;  // its prior counts once
    double std = prior.std[column], offset = prior.offset[column];
    if (IsResponse(column)) {
      std = StdOf(prior, processes, segment, column);
      offset = segment.response[column - kResponseColumns];
      system->log_determinant += 2.0 * std::log(std);
    }
    if (!std::isfinite(std)) continue;
    const double precision = 1.0 / (std * std);
    system->H(place, place) += precision;
    system->b[place] += precision * offset;
    system->constant += 0.5 * precision * offset * offset;
  }
}

std::vector<ChainSmoother::State> LinearJoint::Deviations(size_t segment) const {
  return smoothers_[segment].Deviations(changes_[segment](columns_[segment]));
}

SegmentMoments LinearJoint::Moments(size_t segment) const {
  return smoothers_[segment].Moments(changes_[segment](columns_[segment]),
                                     covariances_[segment](columns_[segment], columns_[segment]));
}

}  // namespace fathom
