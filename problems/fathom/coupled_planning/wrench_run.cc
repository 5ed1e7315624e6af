// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/wrench_run.h"

#include "fathom/coupled/row_whitener.h"
#include "fathom/planning/information.h"
#include "fathom/planning/planned_motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace fathom {
namespace {

// The columns of the start that a fit leaves free: velocities, and the tilt where it moves.
std::vector<Eigen::Index> StartColumns(const CoupledModel& model, std::size_t num_entries) {
  std::vector<Eigen::Index> columns;
  const auto first = static_cast<Eigen::Index>(num_entries);
  const auto num_dofs = static_cast<Eigen::Index>(model.dofs.size());
  for (Eigen::Index i = 0; i < num_dofs; ++i) columns.push_back(first + i);
  for (const Dof dof : model.dofs) {
    if (dof != Dof::kRoll && dof != Dof::kPitch) continue;
    columns.push_back(first + num_dofs + Index(dof) - 3);
  }
  return columns;
}

// Rows of unit noise, DOF by DOF.
MotionDerivatives WhitenedRows(const CoupledModel& model,
                               std::size_t num_entries,
                               const CoupledOutputs& outputs,
                               const WrenchMeasurement& measurement) {
  const std::vector<Eigen::Index> start = StartColumns(model, num_entries);
  const auto num_parameters = static_cast<Eigen::Index>(num_entries);
  const auto num_stamps = static_cast<Eigen::Index>(outputs.velocity.size());
  const auto num_rows = num_stamps * static_cast<Eigen::Index>(model.dofs.size());
  RowMajorRows white(num_rows, num_parameters + static_cast<Eigen::Index>(start.size()));
  Eigen::Index from = 0;
  for (const Dof dof : model.dofs) {
    const auto at = static_cast<std::size_t>(Index(dof));
    auto block = white.middleRows(from, num_stamps);
    for (Eigen::Index stamp = 0; stamp < num_stamps; ++stamp) {
      const auto row = outputs.velocity_sensitivity.row(6 * stamp + Index(dof));
      block.row(stamp).head(num_parameters) = row.head(num_parameters);
      for (std::size_t k = 0; k < start.size(); ++k) {
        block(stamp, num_parameters + static_cast<Eigen::Index>(k)) = row[start[k]];
      }
    }
    block /= measurement.noise[at];
    if (measurement.colour[at].order() > 0) RowWhitener(measurement.colour[at]).Apply(block);
    from += num_stamps;
  }
  return {.by_parameter = white.leftCols(num_parameters),
          .by_start = white.rightCols(static_cast<Eigen::Index>(start.size())),
          .displacement_by_parameter = {},
          .displacement_by_start = {}};
}

// All that a window depends on.
std::vector<double> KeyOf(const CoupledCommand& command,
                          const CoupledState& start,
                          double from,
                          double to) {
  std::vector<double> key = {from, to};
  key.insert(key.end(), start.nu.begin(), start.nu.end());
  key.insert(key.end(), start.attitude.begin(), start.attitude.end());
  key.insert(key.end(), start.position.begin(), start.position.end());
  for (std::size_t i = 0; i < command.time.size() && command.time[i] < to; ++i) {
    if (i + 1 < command.time.size() && command.time[i + 1] <= from) continue;
    key.push_back(command.time[i]);
    key.insert(key.end(), command.force[i].begin(), command.force[i].end());
  }
  return key;
}

}  // namespace

std::optional<std::vector<CoupledState>> WrenchMotion(const CoupledModel& model,
                                                      const CoupledCommand& command,
                                                      std::span<const double> stamps) {
  CoupledInputs inputs;
  inputs.command = command;
  CoupledOutputs outputs;
  const CoupledStamps at = {0.0, {}, {stamps.begin(), stamps.end()}};
  if (!RunCoupled(model, inputs, {}, at, &outputs)) return std::nullopt;
  return std::move(outputs.pose);
}

WrenchInformation::WrenchInformation(const CoupledModel& model,
                                     std::vector<FreeEntry> entries,
                                     const WrenchMeasurement& measurement)
    : model_(model), entries_(std::move(entries)), measurement_(measurement) {}

std::optional<Eigen::MatrixXd> WrenchInformation::Of(const CoupledCommand& command,
                                                     double duration) {
  const auto size = static_cast<Eigen::Index>(entries_.size());
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(size, size);
  CoupledState state;
  for (int i = 0; i * measurement_.window < duration - 1e-9; ++i) {
    const double from = i * measurement_.window;
    const double to = std::min(duration, from + measurement_.window);
    const Window& window = WindowOf(command, state, from, to);
    if (!window.is_finite) return std::nullopt;
    sum += window.information;
    state = window.end;
  }
  return sum;
}

const WrenchInformation::Window& WrenchInformation::WindowOf(const CoupledCommand& command,
                                                             const CoupledState& start,
                                                             double from,
                                                             double to) {
  auto [at, is_new] = known_.try_emplace(KeyOf(command, start, from, to));
  Window& window = at->second;
  if (!is_new) return window;
  CoupledInputs inputs;
  inputs.command = command;
  CoupledStamps stamps = {from, PlannedStamps(to - from, measurement_.period), {to}};
  for (double& stamp : stamps.velocity) stamp += from;
  CoupledOutputs outputs;
  window.is_finite = RunCoupledWithSensitivities(model_, entries_, inputs, start, stamps, &outputs);
  if (!window.is_finite) return window;
  window.information =
      InformationOf(WhitenedRows(model_, entries_.size(), outputs, measurement_), 1.0);
  window.end = outputs.pose.back();
  return window;
}

}  // namespace fathom
