// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/coupled_start.h"

#include "fathom/base/robust_std.h"
#include "fathom/solve/decompositions.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include <Eigen/Core>

namespace fathom {
namespace {

constexpr double kFittedFor = 2.0;  // [s]
constexpr std::size_t kFewestFitted = 10;
constexpr int kNumSteps = 3;  // of Gauss and Newton, the last one without outliers

// From a sample on, those that a start is fitted to.
CoupledStamps StampsFrom(const CoupledSegment& segment, std::size_t sample) {
  const double t = segment.time[sample];
  std::size_t end = sample;
  while (end < segment.time.size() &&
         (segment.time[end] - t <= kFittedFor || end - sample < kFewestFitted)) {
    ++end;
  }
  const auto begin = segment.time.begin();
  return {t,
          {begin + static_cast<std::ptrdiff_t>(sample), begin + static_cast<std::ptrdiff_t>(end)},
          {}};
}

// What a run misses, the samples of one DOF after the other, and its derivatives by the velocities
// at the start. Rows of what was not measured are 0.
struct Misses {
  Eigen::MatrixXd rows;
  Eigen::VectorXd values;
};

// Nothing if the run diverges.
std::optional<Misses> MissesFrom(const CoupledState& start,
                                 const CoupledModel& model,
                                 const CoupledInputs& inputs,
                                 const CoupledStamps& stamps,
                                 std::span<const Vector6> measured) {
  CoupledOutputs outputs;
  if (!RunCoupledWithSensitivities(model, {}, inputs, start, stamps, &outputs)) return {};
  const auto num_dofs = static_cast<Eigen::Index>(model.dofs.size());
  const auto num_stamps = static_cast<Eigen::Index>(stamps.velocity.size());
  Misses misses = {Eigen::MatrixXd::Zero(num_dofs * num_stamps, num_dofs),
                   Eigen::VectorXd::Zero(num_dofs * num_stamps)};
  Eigen::Index row = 0;
  for (const Dof dof : model.dofs) {
    for (Eigen::Index i = 0; i < num_stamps; ++i, ++row) {
      const auto at = static_cast<std::size_t>(i);
      const double miss = measured[at][Index(dof)] - outputs.velocity[at][Index(dof)];
      if (!std::isfinite(miss)) continue;
      misses.values[row] = miss;
      misses.rows.row(row) = outputs.velocity_sensitivity.row(6 * i + Index(dof)).head(num_dofs);
    }
  }
  return misses;
}

// Takes out what is far from what a run shows, as FittedStart() does.
void TakeOutFar(Eigen::Ref<Eigen::MatrixXd> rows, Eigen::Ref<Eigen::VectorXd> misses) {
  constexpr double kFar = 5.0;  // robust standard deviations
  constexpr Eigen::Index kFewestKept = 3;
  const Eigen::ArrayXd sizes = misses.array().abs();
  const double far = kFar * RobustStd({sizes.begin(), sizes.end()});
  if ((sizes <= far).count() < kFewestKept) return;
  for (Eigen::Index i = 0; i < sizes.size(); ++i) {
    if (sizes[i] <= far) continue;
    rows.row(i).setZero();
    misses[i] = 0.0;
  }
}

}  // namespace

CoupledState FittedCoupledStart(const CoupledModel& model,
                                const CoupledData& log,
                                const CoupledSegment& segment,
                                std::size_t sample) {
  const CoupledState measured = MeasuredState(segment, sample);
  const CoupledStamps stamps = StampsFrom(segment, sample);
  const auto num_stamps = static_cast<Eigen::Index>(stamps.velocity.size());
  CoupledState start = measured;
  for (int step = 1; step <= kNumSteps; ++step) {
    auto misses =
        MissesFrom(start, model, log.inputs, stamps, std::span(segment.velocity).subspan(sample));
    if (!misses) return measured;
    for (Eigen::Index row = 0; row < misses->values.size(); row += num_stamps) {
      auto rows = misses->rows.middleRows(row, num_stamps);
      auto of_dof = misses->values.segment(row, num_stamps);
      if (step == kNumSteps) TakeOutFar(rows, of_dof);
      const double size = std::max(of_dof.norm(), 1e-12);
      rows /= size;
      of_dof /= size;
    }
    const Eigen::VectorXd change = LeastSquares(misses->rows, misses->values);
    Eigen::Index column = 0;
    for (const Dof dof : model.dofs) start.nu[Index(dof)] += change[column++];
  }
  return start;
}

}  // namespace fathom
