// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/trends/quiet_archive.h"

#include "fathom/base/random_stream.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <Eigen/Cholesky>

namespace fathom {
namespace {

int NumReaching(std::span<const double> largest, double observed) {
  return static_cast<int>(std::count_if(
      largest.begin(), largest.end(), [&](double value) { return value >= observed; }));
}

std::vector<Eigen::MatrixXd> NoiseFactors(std::span<const DiveBlock> blocks,
                                          std::span<const double> tau_squared) {
  std::vector<Eigen::MatrixXd> factors;
  for (const DiveBlock& block : blocks) {
    Eigen::MatrixXd covariance = block.covariance;
    for (std::size_t i = 0; i < block.series.size(); ++i) {
      covariance(i, i) += tau_squared[block.series[i]];
    }
    factors.push_back(covariance.llt().matrixL());
  }
  return factors;
}

}  // namespace

QuietArchive DrawQuietArchives(std::span<const DiveBlock> blocks,
                               std::span<const Series> series,
                               std::span<const ScanDesign> designs,
                               std::span<const double> tau_squared,
                               const QuietDraws& draws) {
  const std::vector<Eigen::MatrixXd> factors = NoiseFactors(blocks, tau_squared);
  RandomStream random(draws.seed, "archive.trends.quiet");
  std::vector<Eigen::VectorXd> values;
  for (const Series& one : series) values.emplace_back(one.value.size());
  QuietArchive quiet;
  int num_changes = 0;
  int num_dives = 0;
  for (int draw = 0; draw < draws.num_draws; ++draw) {
    if (num_changes > draws.enough_changes && num_dives > draws.enough_dives) break;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kNumParameters, 1> white(factors[b].rows());
      for (double& number : white) number = random.Normal();
      for (Eigen::Index i = 0; i < white.size(); ++i) {
        values[blocks[b].series[i]](blocks[b].element[i]) =
            factors[b].row(i).head(i + 1).dot(white.head(i + 1));
      }
    }
    double largest_change = 0.0;
    double largest_dive = 0.0;
    for (std::size_t s = 0; s < series.size(); ++s) {
      const ScanResult scan = Scan(designs[s], values[s]);
      largest_change = std::max(largest_change, scan.change.statistic);
      largest_dive = std::max(largest_dive, scan.dive.statistic);
    }
    quiet.largest_change.push_back(largest_change);
    quiet.largest_dive.push_back(largest_dive);
    num_changes += largest_change >= draws.observed_change ? 1 : 0;
    num_dives += largest_dive >= draws.observed_dive ? 1 : 0;
  }
  return quiet;
}

double PValue(std::span<const double> largest, double observed) {
  return (1.0 + NumReaching(largest, observed)) / (1.0 + static_cast<double>(largest.size()));
}

double ThresholdAt(std::vector<double> largest, double rate) {
  const int allowed = static_cast<int>(std::floor(rate * (1.0 + largest.size()) + 1e-9)) - 1;
  if (allowed < 0) return std::numeric_limits<double>::infinity();
  std::sort(largest.begin(), largest.end(), std::greater<>());
  if (allowed >= static_cast<int>(largest.size())) return 0.0;
  return std::nextafter(largest[allowed], std::numeric_limits<double>::infinity());
}

}  // namespace fathom
