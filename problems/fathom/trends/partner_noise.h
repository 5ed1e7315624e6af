// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/trends/column.h"
#include "fathom/trends/series.h"

#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// What the other parameters of a dive say of the noise of one: docs/archive_trends.md (3).
struct PartnerTerm {
  int element = 0;  // of the series
  int partner = 0;  // series
  int partner_element = 0;
  double coefficient = 0.0;
};

struct PartnerNoise {
  std::vector<std::vector<PartnerTerm>> terms;  // by series
  std::vector<Eigen::VectorXd> variance;        // of a series' dives, once the partners are known
  std::vector<Eigen::MatrixXd> weighted_basis;  // by series: residuals are y - basis weighted' y
  std::vector<Eigen::MatrixXd> basis;
};

// With a scatter between dives of `tau_squared` and the columns of `columns` in each series.
PartnerNoise PartnerNoiseOf(std::span<const DiveSeries> series,
                            std::span<const DiveBlock> blocks,
                            std::span<const double> tau_squared,
                            std::span<const std::vector<Column>> columns,
                            int num_dives);

// The values of each series less what its partners' residuals say of their noise.
std::vector<Eigen::VectorXd> WithoutPartners(std::span<const Eigen::VectorXd> values,
                                             const PartnerNoise& noise);

}  // namespace fathom
