// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/signal/filters/autoregression.h"

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// Sums over the pieces of psi(r).
struct InfluenceSums {
  double num_samples = 0.0;
  double power = 0.0;    // of squares
  double product = 0.0;  // of neighbours

  double NeighbourCorrelation() const { return product / power; }
};

// Of a residual, or of its means over bins of some samples.
struct Colour {
  std::size_t bin_size;
  Autoregression noise;
  InfluenceSums sums;

  // What the variance of a mean over a long time tends to, times its number of samples.
  double LongRunVariance() const;
};

// The samples' own colour.
Colour ColourOfSamples(const std::vector<std::vector<double>>& influence);

// That colour, or the one of means over bins where these have more of what is slow: among a noise
// that is about white AIC takes little of it for none.
Colour SlowerColour(const Colour& of_samples,
                    const std::vector<std::vector<double>>& influence,
                    std::size_t bin_size);

// The fit bends the residuals towards zero by as many degrees of freedom as it has unknowns, and
// coloured residuals have fewer to give: the effective number of samples is n times the variance of
// a white residual's mean over that of this one. The factor on a covariance that makes up for it.
double FreedomFactor(const Colour& colour, double num_unknowns);

// What means over bins lose of the variance of outputs.
class BinLosses {
 public:
  void Add(const Eigen::VectorXd& output);

  // The most samples in a bin that lose little, and leave many bins of the longest output; 1 where
  // nothing was added.
  std::size_t LargestSize() const;

 private:
  static constexpr std::array<std::size_t, 8> kSizes = {1, 2, 3, 4, 6, 8, 12, 16};

  Eigen::Index longest_ = 0;  // samples
  double all_ = 0.0;
  std::array<double, kSizes.size()> lost_ = {};
};

// Sums of the rows of each bin, as they arrive.
class BinnedRows {
 public:
  BinnedRows(std::size_t size, Eigen::Index num_columns);

  // `is_end`: a piece ends with them, and so does its last bin.
  void Add(const Eigen::Ref<const Eigen::MatrixXd>& rows, bool is_end);

  // Of the bins that the last rows filled.
  const Eigen::MatrixXd& full() const { return full_; }

 private:
  const Eigen::Index size_;
  Eigen::Index num_open_ = 0;
  Eigen::RowVectorXd open_;
  Eigen::MatrixXd full_;
};

}  // namespace fathom
