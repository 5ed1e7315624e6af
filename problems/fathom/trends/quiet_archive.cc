// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/trends/quiet_archive.h"

#include "fathom/base/median.h"
#include "fathom/base/random_stream.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <Eigen/Cholesky>

namespace fathom {
namespace {

constexpr double kLeastExcess = 1e-9;  // of a series in which nothing can be tried

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

QuietArchives DrawQuietArchives(std::span<const DiveBlock> blocks,
                                std::span<const DiveSeries> series,
                                std::span<const ScanDesign> designs,
                                std::span<const double> tau_squared,
                                const PartnerNoise& partner_noise,
                                int num_draws,
                                std::uint64_t seed) {
  const std::vector<Eigen::MatrixXd> factors = NoiseFactors(blocks, tau_squared);
  RandomStream random(seed, "archive.trends.quiet");
  std::vector<Eigen::VectorXd> values;
  for (const DiveSeries& one : series) values.emplace_back(one.value.size());
  QuietArchives quiet{Eigen::MatrixXd(num_draws, series.size()),
                      Eigen::MatrixXd(num_draws, series.size())};
  Eigen::VectorXd white;
  for (int draw = 0; draw < num_draws; ++draw) {
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      white.resize(factors[b].rows());
      for (double& number : white) number = random.Normal();
      for (Eigen::Index i = 0; i < white.size(); ++i) {
        values[blocks[b].series[i]](blocks[b].element[i]) =
            factors[b].row(i).head(i + 1).dot(white.head(i + 1));
      }
    }
    const std::vector<Eigen::VectorXd> cleared = WithoutPartners(values, partner_noise);
    for (std::size_t s = 0; s < series.size(); ++s) {
      const ScanResult scan = Scan(designs[s], cleared[s]);
      quiet.change(draw, s) = BestChange(scan).statistic;
      quiet.dive(draw, s) = BestDive(scan).statistic;
    }
  }
  return quiet;
}

CommonScale CommonScaleOf(const Eigen::MatrixXd& draws) {
  CommonScale scale;
  scale.median.resize(draws.cols());
  scale.mean_excess.resize(draws.cols());
  Eigen::MatrixXd common = draws;
  for (Eigen::Index s = 0; s < draws.cols(); ++s) {
    const auto column = draws.col(s);
    const double median = Median(std::vector<double>(column.begin(), column.end()));
    const double mean_excess = 2.0 * (column.array() - median).max(0.0).mean();
    scale.median(s) = median;
    scale.mean_excess(s) = std::max(mean_excess, kLeastExcess);
    common.col(s) = (column.array() - median) / scale.mean_excess(s);
  }
  for (Eigen::Index draw = 0; draw < draws.rows(); ++draw) {
    scale.largest.push_back(common.cols() > 0 ? common.row(draw).maxCoeff() : 0.0);
  }
  return scale;
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
