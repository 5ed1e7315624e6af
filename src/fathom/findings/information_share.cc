// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/information_share.h"

#include <vector>

#include <Eigen/Cholesky>

namespace fathom {
namespace {

std::optional<Eigen::MatrixXd> InverseOf(const Eigen::MatrixXd& covariance) {
  if (!covariance.allFinite() || !(covariance.diagonal().array() > 0.0).all()) return std::nullopt;
  // The parameters' units differ: correlations are inverted.
  const Eigen::VectorXd scale = covariance.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::LLT<Eigen::MatrixXd> solver(scale.asDiagonal() * covariance * scale.asDiagonal());
  if (solver.info() != Eigen::Success) return std::nullopt;
  const auto n = covariance.rows();
  return scale.asDiagonal() * solver.solve(Eigen::MatrixXd::Identity(n, n)) * scale.asDiagonal();
}

}  // namespace

std::optional<SharedInformation> ShareInformation(std::span<const Eigen::MatrixXd> covariances) {
  if (covariances.empty()) return std::nullopt;
  const auto n = covariances.front().rows();
  std::vector<Eigen::MatrixXd> information;
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(n, n);
  for (const Eigen::MatrixXd& covariance : covariances) {
    auto own = InverseOf(covariance);
    if (!own) return std::nullopt;
    sum += *own;
    information.push_back(*std::move(own));
  }
  const auto together = InverseOf(sum);
  if (!together) return std::nullopt;
  SharedInformation shared = {*together,
                              Eigen::MatrixXd(static_cast<Eigen::Index>(information.size()), n)};
  for (Eigen::Index i = 0; i < shared.share.rows(); ++i) {
    const auto& own = information[static_cast<std::size_t>(i)];
    shared.share.row(i) =
        (*together * own * *together).diagonal().cwiseQuotient(together->diagonal()).transpose();
  }
  return shared;
}

}  // namespace fathom
