// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/row_whitener.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fathom {
namespace {

constexpr Eigen::Index kColumns = 8;

}  // namespace

RowWhitener::RowWhitener(const Autoregression& noise) {
  const auto order = static_cast<std::size_t>(noise.order());
  predictors_.assign(order + 1, {});
  std_.assign(order + 1, 0.0);
  predictors_[order] = noise.coefficients;
  double variance = noise.innovation_variance;
  std_[order] = std::sqrt(variance);
  // Downwards: the last coefficient is the reflection coefficient.
  for (std::size_t n = order; n > 0; --n) {
    const std::vector<double>& longer = predictors_[n];
    const double reflection = longer[n - 1];
    const double rest = 1.0 - reflection * reflection;
    std::vector<double>& shorter = predictors_[n - 1];
    shorter.resize(n - 1);
    for (std::size_t k = 0; k + 1 < n; ++k) {
      shorter[k] = (longer[k] + reflection * longer[n - 2 - k]) / rest;
    }
    variance /= rest;
    std_[n - 1] = std::sqrt(variance);
  }
}

void RowWhitener::Apply(Eigen::Ref<RowMajorRows> rows) const {
  // From the last row up: each takes rows that are not whitened yet.
  for (Eigen::Index i = rows.rows() - 1; i >= 0; --i) {
    const auto n = static_cast<std::size_t>(std::min<Eigen::Index>(i, order()));
    const std::vector<double>& predictor = predictors_[n];
    // A few columns at a time, which stay in registers.
    Eigen::Index column = 0;
    for (; column + kColumns <= rows.cols(); column += kColumns) {
      Eigen::Array<double, kColumns, 1> rest =
          rows.row(i).segment<kColumns>(column).transpose().array();
      for (std::size_t k = 0; k < n; ++k) {
        const auto before = rows.row(i - 1 - static_cast<Eigen::Index>(k));
        rest -= predictor[k] * before.segment<kColumns>(column).transpose().array();
      }
      rows.row(i).segment<kColumns>(column) = (rest / std_[n]).matrix().transpose();
    }
    for (; column < rows.cols(); ++column) {
      double rest = rows(i, column);
      for (std::size_t k = 0; k < n; ++k) {
        rest -= predictor[k] * rows(i - 1 - static_cast<Eigen::Index>(k), column);
      }
      rows(i, column) = rest / std_[n];
    }
  }
}

}  // namespace fathom
