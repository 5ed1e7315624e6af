// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/trends/partner_noise.h"

#include "fathom/solve/decompositions.h"

#include <Eigen/Cholesky>

namespace fathom {
namespace {

void AddTerms(const DiveBlock& block,
              Eigen::Index own,
              std::span<const double> tau_squared,
              PartnerNoise* noise) {
  const Eigen::Index size = static_cast<Eigen::Index>(block.series.size());
  std::vector<Eigen::Index> others;
  for (Eigen::Index i = 0; i < size; ++i) {
    if (i != own) others.push_back(i);
  }
  if (others.empty()) return;
  Eigen::MatrixXd covariance = block.covariance(others, others);
  for (std::size_t i = 0; i < others.size(); ++i) {
    covariance(i, i) += tau_squared[block.series[others[i]]];
  }
  const Eigen::VectorXd shared = block.covariance(others, std::vector<Eigen::Index>{own});
  const Eigen::VectorXd coefficients = covariance.llt().solve(shared);
  const int s = block.series[own];
  noise->variance[s](block.element[own]) -= shared.dot(coefficients);
  for (std::size_t i = 0; i < others.size(); ++i) {
    if (coefficients(i) == 0.0) continue;
    noise->terms[s].push_back(
        {block.element[own], block.series[others[i]], block.element[others[i]], coefficients(i)});
  }
}

}  // namespace

PartnerNoise PartnerNoiseOf(std::span<const DiveSeries> series,
                            std::span<const DiveBlock> blocks,
                            std::span<const double> tau_squared,
                            std::span<const std::vector<Column>> columns,
                            int num_dives) {
  PartnerNoise noise;
  noise.terms.resize(series.size());
  for (std::size_t s = 0; s < series.size(); ++s) {
    noise.variance.push_back(series[s].variance);
    const Eigen::VectorXd root_weight = (series[s].variance.array() + tau_squared[s]).rsqrt();
    const Eigen::MatrixXd weighted =
        root_weight.asDiagonal() * DesignMatrix(series[s], columns[s], num_dives);
    const Eigen::MatrixXd orthonormal = ColumnSpaceOf(weighted, 1e-9).basis;
    noise.basis.push_back(root_weight.cwiseInverse().asDiagonal() * orthonormal);
    noise.weighted_basis.push_back(root_weight.asDiagonal() * orthonormal);
  }
  for (const DiveBlock& block : blocks) {
    for (std::size_t i = 0; i < block.series.size(); ++i) AddTerms(block, i, tau_squared, &noise);
  }
  return noise;
}

std::vector<Eigen::VectorXd> WithoutPartners(std::span<const Eigen::VectorXd> values,
                                             const PartnerNoise& noise) {
  std::vector<Eigen::VectorXd> residuals(values.begin(), values.end());
  for (std::size_t s = 0; s < values.size(); ++s) {
    for (Eigen::Index p = 0; p < noise.basis[s].cols(); ++p) {
      residuals[s] -= noise.weighted_basis[s].col(p).dot(values[s]) * noise.basis[s].col(p);
    }
  }
  std::vector<Eigen::VectorXd> cleared(values.begin(), values.end());
  for (std::size_t s = 0; s < values.size(); ++s) {
    for (const PartnerTerm& term : noise.terms[s]) {
      cleared[s](term.element) -= term.coefficient * residuals[term.partner](term.partner_element);
    }
  }
  return cleared;
}

}  // namespace fathom
