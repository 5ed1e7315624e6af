// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/free_decay/decay_motion.h"
#include "fathom/free_decay/decay_options.h"
#include "fathom/free_decay/decay_stretch.h"
#include "fathom/solve/solve_with_bounds.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// Which unknowns there are, and where they stand: the rates, then three for each stretch, the
// velocity and the displacement at its start and what its displacement is measured from.
class DecayUnknowns {
 public:
  static constexpr int kPerStretch = 3;

  DecayUnknowns(std::size_t num_stretches, const FreeDecayOptions& options);

  int size() const { return kNumDecayRates + kPerStretch * num_stretches_; }
  int FirstOf(std::size_t stretch) const {
    return kNumDecayRates + kPerStretch * static_cast<int>(stretch);
  }

  // Unknowns that no data move: they stay where they start.
  const std::vector<int>& fixed() const { return fixed_; }
  int num_free() const { return size() - static_cast<int>(fixed_.size()); }

 private:
  int num_stretches_;
  std::vector<int> fixed_;
};

// The rates that are never below 0.
std::vector<int> BoundedRates(const FreeDecayOptions& options);

// Residuals, simulated minus measured, and their derivatives by all unknowns.
struct DecayResiduals {
  Eigen::VectorXd residual;
  Eigen::MatrixXd jacobian;
  std::vector<Eigen::Index> begin;  // first row of each stretch, and the number of rows
  double largest_speed = 0.0, smallest_speed = 0.0;  // of the simulated motion
};

// Nothing if the simulation does not stay finite.
std::optional<DecayResiduals> DecayResidualsAt(const Eigen::VectorXd& point,
                                               std::span<const DecayStretch> stretches,
                                               DecayOutput output);

struct DecayPoint {
  Eigen::VectorXd unknowns;
  BoundedSolve solve;
};

// Where Huber's loss of the residuals over `sigma` is least, with no damping and no stiffness below
// 0. `k`: infinite for squares.
DecayPoint SearchDecay(const Eigen::VectorXd& start,
                       std::span<const DecayStretch> stretches,
                       const FreeDecayOptions& options,
                       double sigma,
                       double k);

}  // namespace fathom
