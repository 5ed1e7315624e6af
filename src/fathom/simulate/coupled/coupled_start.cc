// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/coupled_start.h"

#include "fathom/solve/decompositions.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Core>

namespace fathom {
namespace {

constexpr double kFittedFor = 2.0;  // [s]
constexpr std::size_t kFewestFitted = 10;
constexpr int kNumSteps = 2;  // of Gauss and Newton

// Samples from one on that a start is fitted to.
std::vector<double> StampsFrom(const CoupledSegment& segment, std::size_t sample) {
  const double t = segment.time[sample];
  std::size_t end = sample;
  while (end < segment.time.size() &&
         (segment.time[end] - t <= kFittedFor || end - sample < kFewestFitted)) {
    ++end;
  }
  const auto begin = segment.time.begin();
  return {begin + static_cast<std::ptrdiff_t>(sample), begin + static_cast<std::ptrdiff_t>(end)};
}

}  // namespace

CoupledState FittedCoupledStart(const CoupledModel& model,
                                const CoupledData& log,
                                const CoupledSegment& segment,
                                std::size_t sample) {
  const CoupledState measured = MeasuredState(segment, sample);
  const CoupledStamps stamps = {segment.time[sample], StampsFrom(segment, sample), {}};
  const auto num_dofs = static_cast<Eigen::Index>(model.dofs.size());
  CoupledState start = measured;
  Vector6 scale = Vector6::Zero();
  for (int step = 0; step < kNumSteps; ++step) {
    CoupledOutputs outputs;
    if (!RunCoupledWithSensitivities(model, {}, log.inputs, start, stamps, &outputs)) {
      return measured;
    }
    const auto num_stamps = static_cast<Eigen::Index>(stamps.velocity.size());
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(num_dofs * num_stamps, num_dofs);
    Eigen::VectorXd misses = Eigen::VectorXd::Zero(num_dofs * num_stamps);
    for (Eigen::Index k = 0; k < num_dofs; ++k) {
      const Eigen::Index dof = Index(model.dofs[static_cast<std::size_t>(k)]);
      for (Eigen::Index i = 0; i < num_stamps; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const double miss = segment.velocity[sample + at][dof] - outputs.velocity[at][dof];
        if (!std::isfinite(miss)) continue;
        misses[k * num_stamps + i] = miss;
        rows.row(k * num_stamps + i) = outputs.velocity_sensitivity.row(6 * i + dof).head(num_dofs);
      }
      auto of_dof = misses.segment(k * num_stamps, num_stamps);
      if (step == 0) scale[dof] = std::max(of_dof.norm(), 1e-12);
      of_dof /= scale[dof];
      rows.middleRows(k * num_stamps, num_stamps) /= scale[dof];
    }
    const Eigen::VectorXd change = LeastSquares(rows, misses);
    for (Eigen::Index k = 0; k < num_dofs; ++k) {
      start.nu[Index(model.dofs[static_cast<std::size_t>(k)])] += change[k];
    }
  }
  return start;
}

}  // namespace fathom
