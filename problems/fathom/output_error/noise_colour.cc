// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/noise_colour.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fathom {
namespace {

constexpr double kAboutWhite = 0.7;  // correlation of neighbours: above, what is slow shows
constexpr std::size_t kFewestBins = 300;
constexpr double kMostLost = 0.005;  // of the variance of the output, by means over bins

// Means of so many values, the last of fewer.
std::vector<std::vector<double>> Binned(const std::vector<std::vector<double>>& pieces,
                                        size_t size) {
  std::vector<std::vector<double>> binned;
  for (const std::vector<double>& piece : pieces) {
    std::vector<double>& means = binned.emplace_back();
    for (size_t i = 0; i < piece.size(); i += size) {
      const size_t end = std::min(i + size, piece.size());
      double sum = 0.0;
      for (size_t j = i; j < end; ++j) sum += piece[j];
      means.push_back(sum / static_cast<double>(end - i));
    }
  }
  return binned;
}

Autoregression NoiseOf(std::vector<std::vector<double>> influence, double num_samples) {
  const double most = std::min({60.0, 10.0 * std::log10(num_samples), num_samples / 10.0});
  return FitAutoregression(std::move(influence), static_cast<int>(most));
}

// 1 - phi_1 - ... - phi_p.
double WhiteSum(const Autoregression& noise) {
  double sum = 1.0;
  for (const double phi : noise.coefficients) sum -= phi;
  return sum;
}

InfluenceSums SumsOf(const std::vector<std::vector<double>>& influence) {
  InfluenceSums sums;
  for (const auto& psi : influence) {
    sums.num_samples += static_cast<double>(psi.size());
    for (size_t i = 0; i < psi.size(); ++i) {
      sums.power += psi[i] * psi[i];
      if (i > 0) sums.product += psi[i] * psi[i - 1];
    }
  }
  return sums;
}

}  // namespace

double Colour::LongRunVariance() const {
  const double sum = WhiteSum(noise);
  return static_cast<double>(bin_size) * noise.innovation_variance / (sum * sum);
}

Colour ColourOfSamples(const std::vector<std::vector<double>>& influence) {
  const InfluenceSums sums = SumsOf(influence);
  return {1, NoiseOf(influence, sums.num_samples), sums};
}

Colour SlowerColour(const Colour& of_samples,
                    const std::vector<std::vector<double>>& influence,
                    std::size_t bin_size) {
  if (bin_size == 1 || of_samples.sums.NeighbourCorrelation() > kAboutWhite) return of_samples;
  Colour of_means = ColourOfSamples(Binned(influence, bin_size));
  of_means.bin_size = bin_size;
  return of_means.LongRunVariance() > of_samples.LongRunVariance() ? of_means : of_samples;
}

double FreedomFactor(const Colour& colour, double num_unknowns) {
  const double sum = WhiteSum(colour.noise);
  const double num_samples = colour.sums.num_samples;
  const double variance = colour.sums.power / num_samples;
  const double shrink = std::min(1.0, variance * sum * sum / colour.noise.innovation_variance);
  const double num_effective = std::max(num_samples * shrink, 2.0 * num_unknowns);
  return num_effective / (num_effective - num_unknowns);
}

void BinLosses::Add(const Eigen::VectorXd& output) {
  const Eigen::ArrayXd about = output.array() - output.mean();
  longest_ = std::max(longest_, output.size());
  all_ += about.square().sum();
  for (std::size_t k = 0; k < kSizes.size(); ++k) {
    const auto size = static_cast<Eigen::Index>(kSizes[k]);
    for (Eigen::Index i = 0; i < about.size(); i += size) {
      const auto bin = about.segment(i, std::min(size, about.size() - i));
      lost_[k] += (bin - bin.mean()).square().sum();
    }
  }
}

std::size_t BinLosses::LargestSize() const {
  std::size_t largest = 1;
  for (std::size_t k = 0; k < kSizes.size() && all_ > 0.0; ++k) {
    const bool are_many = static_cast<std::size_t>(longest_) >= kFewestBins * kSizes[k];
    if (are_many && lost_[k] <= kMostLost * all_) largest = kSizes[k];
  }
  return largest;
}

BinnedRows::BinnedRows(std::size_t size, Eigen::Index num_columns)
    : size_(static_cast<Eigen::Index>(size)), open_(Eigen::RowVectorXd::Zero(num_columns)) {}

void BinnedRows::Add(const Eigen::Ref<const Eigen::MatrixXd>& rows, bool is_end) {
  full_.resize((num_open_ + rows.rows()) / size_ + 1, rows.cols());
  Eigen::Index num_full = 0;
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    open_ += rows.row(i);
    const bool is_last = is_end && i + 1 == rows.rows();
    if (++num_open_ < size_ && !is_last) continue;
    full_.row(num_full++) = open_;
    open_.setZero();
    num_open_ = 0;
  }
  full_.conservativeResize(num_full, Eigen::NoChange);
}

}  // namespace fathom
