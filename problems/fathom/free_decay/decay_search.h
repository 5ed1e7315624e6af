// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/free_decay/decay_motion.h"
#include "fathom/free_decay/decay_options.h"
#include "fathom/free_decay/decay_stretch.h"
#include "fathom/solve/active_set.h"

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

// Huber's loss of the residuals over `sigma` by the unknowns, by Levenberg and Marquardt's method.
class DecaySearch : public BoundedSearch {
 public:
  // `k`: infinite for squares.
  DecaySearch(std::span<const DecayStretch> stretches,
              DecayOutput output,
              std::vector<int> fixed,
              double sigma,
              double k,
              Eigen::VectorXd* point);

  Optimum Solve(const std::vector<int>& held) override;
  double Value(int unknown) const override { return (*point_)[unknown]; }
  void SetToZero(int unknown) override { (*point_)[unknown] = 0.0; }
  std::vector<double> Point() const override;
  void GoTo(const std::vector<double>& point) override;

 private:
  double CostOf(const Eigen::VectorXd& residual) const;

  std::span<const DecayStretch> stretches_;
  DecayOutput output_;
  std::vector<int> fixed_;
  double sigma_, k_;
  Eigen::VectorXd* point_;
};

}  // namespace fathom
