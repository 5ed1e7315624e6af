// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/trends/column.h"
#include "fathom/trends/dive_estimate.h"
#include "fathom/trends/series.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

enum class PatternSign { kAny, kGrows, kShrinks };

// How a cause moves the parameters of a vehicle: archive_trends.md (8).
//
//   difference_s = directions_s z + before_s (1 / (1 - f share_s) - 1)
//
// One row for each series; a row of zeros is a parameter that this cause leaves alone.
struct Pattern {
  std::string cause;           // "payload", "thruster(port)", ...
  Eigen::MatrixXd directions;  // in units of the series' scales
  Eigen::VectorXd share;       // of the parameter that goes with f; zeros: there is no f

  // The share in each dive as it was commanded, by series and dive, NaN where that is not known. A
  // controller that holds the heading shifts the work from a weak thruster to the others, or to it.
  // Empty: `share` holds in every dive.
  Eigen::MatrixXd share_of_dive = {};

  PatternSign sign = PatternSign::kAny;  // of z and of the parameters that follow f

  bool HasFactor() const { return (share.array() != 0.0).any(); }
  int NumFree() const { return static_cast<int>(directions.cols()) + (HasFactor() ? 1 : 0); }
  bool Moves(Eigen::Index s) const {
    return share(s) != 0.0 || (directions.row(s).array() != 0.0).any();
  }
};

// Every cause that this archive can show, some of them in several forms: one factor or free sizes,
// some DOFs or all. `mean_correlation` is that of the noise of dives,
// as MeanCorrelation gives it.
std::vector<Pattern> PatternsOf(std::span<const DiveSeries> series,
                                std::span<const DiveEstimate> estimates,
                                int num_dives,
                                const Eigen::MatrixXd& mean_correlation,
                                const std::optional<Vehicle>& vehicle);

// The patterns as they are at an event: with the shares of the dives from its step on, or, of a
// trend, of all.
std::vector<Pattern> PatternsAt(std::span<const Pattern> patterns, const Column& column);

// Of the noise of dives, between all series.
Eigen::MatrixXd MeanCorrelation(std::span<const DiveBlock> blocks, std::size_t num_series);

}  // namespace fathom
