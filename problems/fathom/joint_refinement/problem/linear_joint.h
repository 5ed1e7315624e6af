// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/motion/linear_segment.h"
#include "fathom/joint_refinement/problem/chain_smoother.h"
#include "fathom/joint_refinement/processes/process_set.h"

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// Of a response that is taken away where the point of linearisation still has it, as `coefficient`
// [m] or [rad]: it returns to 0, wherever the corners would have it. (A fixed one would be more
// than some responses are: those of a coordinate held still are seen to a millionth.)
inline double NoResponseStd(double coefficient) { return 1e-4 * std::abs(coefficient); }

// Knowledge of the globals beyond what the processes say, column by column: an infinite std is no
// knowledge, 0 holds the column where it is.
struct GlobalsPrior {
  std::array<double, kNumColumns> std;
  std::array<double, kNumColumns> offset = {};  // present value less the prior's mean

  GlobalsPrior() { std.fill(std::numeric_limits<double>::infinity()); }
};

// Information about the size scale and the mount; 0 in the rows and columns of what is held.
using SetupInformation = Eigen::Matrix<double, kSetupColumns, kSetupColumns>;

// All segments, linearised at one point, solved under one set of processes:
// docs/joint_refinement.md (8) to (10). Columns shared by the segments take their prior from the
// first one.
class LinearJoint {
 public:
  // `segments` must outlive this object. With `setup`, what all rows and priors together tell of
  // the size scale and the mount is replaced by it, everything else unknown: the linear problem, in
  // which the wander that is seen is a number, is no judge of that. docs/joint_refinement.md (15)
  LinearJoint(std::span<const LinearSegment> segments,
              std::span<const GlobalsPrior> priors,
              const ProcessSet& processes,
              int excited,
              const SetupInformation* setup = nullptr);

  // False if some unknown leaves no trace; the rest then means nothing.
  bool is_usable() const { return is_usable_; }

  double log_likelihood() const { return log_likelihood_; }  // restricted
  double cost() const { return cost_; }                      // half the squares, prior and all
  int num_unknowns() const { return num_unknowns_; }

  // Of a segment's kNumColumns globals; 0 where they are held.
  const Eigen::VectorXd& change(size_t segment) const { return changes_[segment]; }
  const Eigen::MatrixXd& covariance(size_t segment) const { return covariances_[segment]; }

  std::vector<ChainSmoother::State> Deviations(size_t segment) const;
  SegmentMoments Moments(size_t segment) const;

  // The globals of a segment that are not held, rising, and ChainSmoother::ForEachFrame() over
  // them.
  const std::vector<int>& columns(size_t segment) const { return columns_[segment]; }
  void ForEachFrame(size_t segment,
                    const std::function<void(size_t frame,
                                             const ChainSmoother::Square& P,
                                             const ChainSmoother::Border& G)>& visit) const {
    smoothers_[segment].ForEachFrame(visit);
  }

 private:
  struct System;

  // Which columns are not held, and where they stand in the system of all segments.
  System LayOutColumns(std::span<const LinearSegment> segments,
                       std::span<const GlobalsPrior> priors,
                       const ProcessSet& processes);
  void AddPriors(const LinearSegment& segment,
                 const GlobalsPrior& prior,
                 const ProcessSet& processes,
                 size_t r,
                 System* system) const;

  bool is_usable_ = false;
  double log_likelihood_ = -std::numeric_limits<double>::infinity();
  double cost_ = std::numeric_limits<double>::infinity();
  int num_unknowns_ = 0;
  std::vector<std::vector<int>> columns_;  // of each segment, not held
  std::vector<ChainSmoother> smoothers_;
  std::vector<Eigen::VectorXd> changes_;
  std::vector<Eigen::MatrixXd> covariances_;
};

// True for the columns of c_j1, c_j2 and c_j3, which process_set.h gives a prior; their held slot.
bool IsResponse(int column);
int HeldSlot(int column);

}  // namespace fathom
