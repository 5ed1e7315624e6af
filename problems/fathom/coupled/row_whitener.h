// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/signal/filters/autoregression.h"

#include <vector>

#include <Eigen/Core>

namespace fathom {

using RowMajorRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Turns equally spaced samples of coloured noise into white noise of variance 1, exactly also in
// the first ones: each sample less what those before it in its piece predict, by the recursion of
// Levinson and Durbin.
class RowWhitener {
 public:
  // White noise of variance 1 is left as it is.
  RowWhitener() = default;
  explicit RowWhitener(const Autoregression& noise);

  // The rows of one piece, consecutive samples, any number of columns.
  void Apply(Eigen::Ref<RowMajorRows> rows) const;

  // Of the noise: phi_1 ...
  const std::vector<double>& coefficients() const { return predictors_.back(); }
  int order() const { return static_cast<int>(predictors_.size()) - 1; }

 private:
  std::vector<std::vector<double>> predictors_ = {{}};  // by how many samples stand before
  std::vector<double> std_ = {1.0};                     // of what they do not predict
};

}  // namespace fathom
