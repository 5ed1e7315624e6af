// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/trends/column.h"
#include "fathom/trends/series.h"

#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// All that the likelihoods of a series' candidates need and that its values do not change, for one
// scatter between dives.
struct ScanAtTau {
  double tau_squared = 0.0;  // in units of the series' scale squared
  double log_det = 0.0;      // of the covariance of the values
  double log_det_information = 0.0;
  Eigen::VectorXd root_weight;
  Eigen::MatrixXd basis;         // orthonormal, of the weighted columns in the model
  Eigen::VectorXd gain;          // 1 / (c' P c) of each candidate, 0 where it cannot be tried
  Eigen::ArrayXd half_log_gain;  // 0 there
};

// One more change of a series that has some already, at every place: docs/archive_trends.md (4).
// With n dives candidate k is a step between the dives k and k + 1 for k < n - 1, the trend for
// k = n - 1, and a value of its own for dive k - n from n on.
struct ScanDesign {
  int num_dives = 0;      // of the series
  double freedom = 0.0;   // what the model and one candidate leave of the dives
  Eigen::VectorXd trend;  // the candidate's column
  std::vector<ScanAtTau> at_tau;
};

ScanDesign MakeScanDesign(const DiveSeries& series, std::span<const Column> model, int num_dives);

struct ScanResult {
  Eigen::ArrayXd statistic;              // of each candidate, 0 where it cannot be tried
  Eigen::ArrayXd candidate_tau_squared;  // with it in the model, by restricted likelihood
  double log_likelihood = 0.0;           // of the model, at its most likely tau
  double tau_squared = 0.0;              // of the model, by restricted likelihood
};

// Takes O(dives) for each tau.
ScanResult Scan(const ScanDesign& design, const Eigen::VectorXd& value);

struct ScanCandidate {
  int index = -1;  // none could be tried
  double statistic = 0.0;
};

// The most telling step or trend, and the most telling value of its own.
ScanCandidate BestChange(const ScanResult& scan);
ScanCandidate BestDive(const ScanResult& scan);

// Of a step or a trend, and back.
Column ColumnOf(const DiveSeries& series, int candidate);
int CandidateOf(const DiveSeries& series, const Column& column);

}  // namespace fathom
