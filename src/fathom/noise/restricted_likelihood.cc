// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/noise/restricted_likelihood.h"

#include "fathom/solve/decompositions.h"

#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>
#include <glog/logging.h>

namespace fathom {

RestrictedLikelihood::RestrictedLikelihood(std::span<const NoiseSample> samples,
                                           std::span<const double> residual,
                                           const Eigen::Ref<const RowMajorMatrix>& design)
    : samples_(samples) {
  const auto n = static_cast<Eigen::Index>(samples.size());
  CHECK_EQ(residual.size(), samples.size());
  CHECK(design.cols() == 0 || design.rows() == n);
  Eigen::VectorXd e = Eigen::Map<const Eigen::VectorXd>(residual.data(), n);
  Eigen::MatrixXd base;
  if (design.cols() > 0) {
    // Lengths of the columns carry units; rank must not depend on them.
    Eigen::MatrixXd scaled = design;
    for (auto column : scaled.colwise()) {
      const double length = column.norm();
      if (length > 0.0) column /= length;
    }
    base = ColumnSpaceOf(scaled, 1e-9).basis;
    rank_ = static_cast<int>(base.cols());
    e -= base * (base.transpose() * e);
  }
  columns_ = RowMajorMatrix::Zero(n, (rank_ + 4) / 4 * 4);
  if (rank_ > 0) columns_.leftCols(rank_) = base;
  columns_.col(rank_) = e;
}

RestrictedLikelihood::Value RestrictedLikelihood::At(const NoiseModel& model) const {
  const Whitener whitener(model, samples_);
  RowMajorMatrix whitened = columns_;
  whitener.Apply(whitened, whitened);

  // docs/residual_noise.md (9): the Cholesky factor of D' S^-1 D, and the residual less what D
  // explains of it.
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(whitened.cols(), whitened.cols());
  gram.selfadjointView<Eigen::Lower>().rankUpdate(whitened.transpose());
  Eigen::VectorXd left = whitened.col(rank_);
  double log_determinant = whitener.log_determinant();
  if (rank_ > 0) {
    const Eigen::LLT<Eigen::MatrixXd> llt(gram.topLeftCorner(rank_, rank_));
    log_determinant += 2.0 * llt.matrixLLT().diagonal().array().log().sum();
    left -= whitened.leftCols(rank_) * llt.solve(gram.row(rank_).head(rank_).transpose());
  }
  const double num_free = static_cast<double>(samples_.size()) - rank_;
  const double variance = left.squaredNorm() / num_free;

  Value value;
  value.factor = std::sqrt(variance);
  value.log_likelihood =
      -0.5 * (num_free * (std::log(2.0 * std::numbers::pi * variance) + 1.0) + log_determinant);
  left /= value.factor;
  value.standardised.assign(left.data(), left.data() + left.size());
  value.log_variances = whitener.LogVariances();
  return value;
}

double RestrictedLikelihood::RootMeanSquare(NoiseChannel channel) const {
  double sum = 0.0, count = 0.0;
  for (size_t i = 0; i < samples_.size(); ++i) {
    if (samples_[i].channel != channel) continue;
    const double e = columns_(static_cast<Eigen::Index>(i), rank_);
    sum += e * e;
    count += 1.0;
  }
  return count > 0.0 ? std::sqrt(sum / count) : 0.0;
}

}  // namespace fathom
