// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/trends/change.h"
#include "fathom/trends/dive_estimate.h"

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// One number of a model over the dives that know it, in the order of dives. Of a coupled model one
// that a model of one DOF has too stands for that: offset.yaw for the buoyancy in yaw.
struct DiveSeries {
  Dof dof = Dof::kSurge;
  int parameter = 0;          // index in kParameterInfo, or kNoParameter
  std::vector<int> dive;      // places in the order of dives
  std::vector<int> estimate;  // which estimate holds it
  double scale = 1.0;         // median standard deviation of a dive [unit of the parameter]
  Eigen::VectorXd value;      // in units of `scale`
  Eigen::VectorXd variance;   // of each value, in units of `scale` squared, above 0

  std::optional<FreeEntry> entry = {};  // of a coupled model
  std::vector<int> number = {};         // which of the estimate's values it is

  // Of a thruster, a shaft or a fin: it belongs to no DOF.
  bool IsOfActuator() const { return entry && fathom::IsOfActuator(*entry); }
};

// The series of an archive, by DOF and parameter, then by the name of the entry. A dive is left out
// of a series where its value or variance is not finite, its variance not above 0, or its place not
// one of `num_dives`; a series, where fewer than `least_dives` remain.
std::vector<DiveSeries> SeriesOf(std::span<const DiveEstimate> estimates,
                                 int num_dives,
                                 int least_dives);

// The same series without the element `index` of it.
DiveSeries WithoutElement(const DiveSeries& series, int index);

// What one estimate says of several series at once.
struct DiveBlock {
  std::vector<int> series;     // at most one of each number
  std::vector<int> element;    // place in that series
  Eigen::MatrixXd covariance;  // in units of the series' scales
};

// The estimates behind `series`, with the covariance of what each of them adds to the series.
// Covariances that are not known or that no noise can have are taken as 0.
std::vector<DiveBlock> BlocksOf(std::span<const DiveEstimate> estimates,
                                std::span<const DiveSeries> series);

}  // namespace fathom
