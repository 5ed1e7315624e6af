// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/trends/partner_noise.h"
#include "fathom/trends/scan.h"
#include "fathom/trends/series.h"

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// The largest statistics of each series in archives in which nothing further changes: a row for
// each draw, a column for each series.
struct QuietArchives {
  Eigen::MatrixXd change;  // of steps and trends
  Eigen::MatrixXd dive;    // of values of their own
};

// Draws archives with the same dives, covariances and scatter between dives. The model's columns
// need not be drawn: every candidate is judged after them. The same seed gives the same draws.
QuietArchives DrawQuietArchives(std::span<const DiveBlock> blocks,
                                std::span<const DiveSeries> series,
                                std::span<const ScanDesign> designs,
                                std::span<const double> tau_squared,
                                const PartnerNoise& partner_noise,
                                int num_draws,
                                std::uint64_t seed);

// What statistics of several series have in common once each is brought to the scale of its own
// quiet draws: short or scattered series have heavier tails, and would drown the others.
struct CommonScale {
  Eigen::VectorXd median;       // of each series
  Eigen::VectorXd mean_excess;  // over the median
  std::vector<double> largest;  // over the series, in each draw, on the common scale

  double OnScale(std::size_t series, double statistic) const {
    return (statistic - median(series)) / mean_excess(series);
  }
  double FromScale(std::size_t series, double value) const {
    return median(series) + mean_excess(series) * value;
  }
};

CommonScale CommonScaleOf(const Eigen::MatrixXd& draws);

// (1 + those at least as large) / (1 + draws).
double PValue(std::span<const double> largest, double observed);

// The smallest statistic that would still have a p-value of at most `rate`; infinite where there
// are too few draws for any.
double ThresholdAt(std::vector<double> largest, double rate);

}  // namespace fathom
