// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/search/screen/screen.h"

#include "fathom/base/random_stream.h"
#include "fathom/solve/decompositions.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Core>

namespace fathom {
namespace {

constexpr double kLeastShare = 1e-5;  // of a signature that survives, below which it is rounding

// Signatures and residual, whitened and cleared of what the fitted model can imitate.
struct Cleared {
  Eigen::MatrixXd columns;
  Eigen::VectorXd norms;  // of the columns before
  Eigen::VectorXd residual;
};

Cleared Clear(const StructureFit& fit, const RowMajorMatrix& signatures, const Whitener& whitener) {
  const Eigen::Index n = fit.residual.size();
  const Eigen::Index num_fitted = fit.jacobian.cols();
  const Eigen::Index num_columns = signatures.cols();
  Cleared cleared;
  cleared.columns.resize(n, num_columns);
  Eigen::MatrixXd fitted(n, num_fitted);
  {
    RowMajorMatrix block(n, num_fitted + 1 + num_columns);
    block.leftCols(num_fitted) = fit.jacobian;
    block.col(num_fitted) = fit.residual;
    block.rightCols(num_columns) = signatures;
    whitener.Apply(block, block);
    fitted = block.leftCols(num_fitted);
    cleared.residual = block.col(num_fitted);
    cleared.columns = block.rightCols(num_columns);
  }  // a long log's block takes as much memory as all else
  for (auto column : fitted.colwise()) column /= std::max(column.norm(), 1e-300);
  const Eigen::MatrixXd Q = ColumnSpaceOf(fitted, 1e-9).basis;
  cleared.norms = cleared.columns.colwise().norm();
  const Eigen::MatrixXd imitated = Q.transpose() * cleared.columns;
  cleared.columns.noalias() -= Q * imitated;
  cleared.residual -= Q * (Q.transpose() * cleared.residual);
  return cleared;
}

// The columns of one trial, of length 1 and orthogonal to each other; zero where nothing of one is
// left beside the others.
Eigen::MatrixXd UnitColumns(const Eigen::MatrixXd& own, const Eigen::VectorXd& norms) {
  Eigen::MatrixXd basis = own;
  for (Eigen::Index k = 0; k < basis.cols(); ++k) {
    for (Eigen::Index j = 0; j < k; ++j) {
      basis.col(k) -= basis.col(j).dot(basis.col(k)) * basis.col(j);
    }
    const double length = basis.col(k).norm();
    basis.col(k) *= length > 1e-9 * norms[k] ? 1.0 / length : 0.0;
  }
  return basis;
}

}  // namespace

Screen::Screen(const StructureFit& fit, const Trials* trials, const Whitener& whitener)
    : trials_(trials) {
  Cleared cleared = Clear(fit, trials->signatures, whitener);
  unit_ = std::move(cleared.columns);  // each trial's columns take the place of its own
  const size_t num_trials = trials->trials.size();
  scores_.assign(num_trials, 0.0);
  amounts_.resize(num_trials);
  responses_.resize(num_trials);
  for (size_t t = 0; t < num_trials; ++t) {
    const Trial& trial = trials->trials[t];
    const int first = trial.first_column, count = trial.num_columns;
    amounts_[t].assign(count, 0.0);
    const Eigen::MatrixXd own = unit_.middleCols(first, count);
    unit_.middleCols(first, count).setZero();
    const Eigen::VectorXd norms = cleared.norms.segment(first, count);
    double surviving_share = 0.0;  // of the signature: what the fitted model cannot imitate
    for (int k = 0; k < count; ++k) {
      if (!(norms[k] > 0.0)) continue;
      surviving_share = std::max(surviving_share, own.col(k).norm() / norms[k]);
    }
    if (!(surviving_share > kLeastShare)) continue;
    const Eigen::MatrixXd basis = UnitColumns(own, norms);
    unit_.middleCols(first, count) = basis;
    if (count == 1) responses_[t] = {own.col(0).dot(cleared.residual), own.col(0).squaredNorm()};
    const Eigen::VectorXd amounts = LeastSquares(own, cleared.residual);
    if (!trial.any_sign && count == 1 && amounts[0] <= 0.0) continue;
    for (int k = 0; k < count; ++k) amounts_[t][k] = amounts[k];
    scores_[t] = (basis.transpose() * cleared.residual).squaredNorm();
  }
  projected_ = unit_.transpose() * cleared.residual;
}

Eigen::MatrixXd Screen::PairScores(const std::vector<int>& some) const {
  std::vector<Eigen::Index> first, columns;
  for (const int t : some) {
    first.push_back(std::ssize(columns));
    const Trial& trial = trials_->trials[t];
    for (int k = 0; k < trial.num_columns; ++k) columns.push_back(trial.first_column + k);
  }
  first.push_back(std::ssize(columns));
  const Eigen::MatrixXd unit = unit_(Eigen::all, columns);
  const Eigen::VectorXd projected = projected_(columns);
  const Eigen::MatrixXd products = unit.transpose() * unit;
  const auto score = [&](std::size_t a, std::size_t b) {
    std::vector<Eigen::Index> both;
    for (const std::size_t t : {a, b}) {
      for (Eigen::Index c = first[t]; c < first[t + 1]; ++c) both.push_back(c);
    }
    const Eigen::VectorXd inner = projected(both);
    const Eigen::VectorXd solved = SolveSymmetric(products(both, both), inner);
    return solved.allFinite() ? inner.dot(solved) : 0.0;
  };
  Eigen::MatrixXd scores = Eigen::MatrixXd::Zero(std::ssize(some), std::ssize(some));
  for (std::size_t a = 0; a < some.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const auto i = static_cast<Eigen::Index>(a), j = static_cast<Eigen::Index>(b);
      scores(i, j) = scores(j, i) = score(b, a);
    }
  }
  return scores;
}

Eigen::MatrixXd Screen::NullMaxima(int num_draws, int num_suspects, std::uint64_t seed) const {
  RandomStream random(seed, "diagnosis.null");
  const Eigen::Index n = unit_.rows();
  Eigen::MatrixXd maxima = Eigen::MatrixXd::Zero(num_draws, num_suspects);
  constexpr int kBlock = 64;
  for (int done = 0; done < num_draws; done += kBlock) {
    const int count = std::min(kBlock, num_draws - done);
    Eigen::MatrixXd noise(n, count);
    for (double& number : noise.reshaped()) number = random.Normal();
    const Eigen::MatrixXd z = unit_.transpose() * noise;
    for (int draw = 0; draw < count; ++draw) {
      for (const Trial& trial : trials_->trials) {
        const auto own = z.col(draw).segment(trial.first_column, trial.num_columns);
        // Half of the one-sided trials would have the wrong sign.
        if (!trial.any_sign && trial.num_columns == 1 && own[0] <= 0.0) continue;
        double& most = maxima(done + draw, trial.suspect);
        most = std::max(most, own.squaredNorm());
      }
    }
  }
  return maxima;
}

}  // namespace fathom
