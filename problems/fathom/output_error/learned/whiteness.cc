// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/learned/whiteness.h"

#include "fathom/base/median.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

namespace fathom {
namespace {

constexpr double kWildStds = 6.0;
constexpr double kStdPerMedianSize = 1.4826;  // of normal samples

struct Squares {
  double sum = 0.0, count = 0.0;

  double Mean() const { return sum / count; }
};

// Sums of neighbours over the root of two: what is white keeps its variance. An odd last one goes.
std::vector<double> InPairs(const std::vector<double>& values) {
  std::vector<double> pairs(values.size() / 2);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    pairs[i] = (values[2 * i] + values[2 * i + 1]) * M_SQRT1_2;
  }
  return pairs;
}

Squares SquaresOf(const std::vector<std::vector<double>>& pieces) {
  Squares squares;
  for (const auto& piece : pieces) {
    for (const double value : piece) squares.sum += value * value;
    squares.count += static_cast<double>(piece.size());
  }
  return squares;
}

// About zero.
double RobustStd(const std::vector<std::vector<double>>& pieces) {
  std::vector<double> sizes;
  for (const auto& piece : pieces) {
    for (const double value : piece) sizes.push_back(std::abs(value));
  }
  return sizes.empty() ? 0.0 : kStdPerMedianSize * Median(std::move(sizes));
}

}  // namespace

bool IsWhite(const std::vector<std::vector<double>>& residuals) {
  constexpr double kFewestMeans = 32.0, kNumStd = 2.0;
  const double limit = kWildStds * RobustStd(residuals);
  std::vector<std::vector<double>> pieces(residuals.size());
  for (std::size_t s = 0; s < residuals.size(); ++s) {
    std::copy_if(
        residuals[s].begin(), residuals[s].end(), std::back_inserter(pieces[s]), [&](double value) {
          return std::abs(value) <= limit;
        });
  }
  const Squares all = SquaresOf(pieces);
  while (true) {
    for (auto& piece : pieces) piece = InPairs(piece);
    const Squares squares = SquaresOf(pieces);
    if (squares.count < kFewestMeans) return true;
    const double relative_std = std::sqrt(2.0 / squares.count - 2.0 / all.count);
    if (squares.Mean() > (1.0 + kNumStd * relative_std) * all.Mean()) return false;
  }
}

}  // namespace fathom
