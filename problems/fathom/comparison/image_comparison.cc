// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/image_comparison.h"

#include "fathom/comparison/check_rows.h"
#include "fathom/findings/log_check.h"
#include "fathom/identification/joint_identification.h"
#include "fathom/signal/joined_signals.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

bool HasVelocity(const Log& log, Dof dof) {
  return log.velocity && log.velocity->Find(VelocityColumn(dof)) != nullptr;
}

}  // namespace

std::vector<HeldDofFound> HeldDofsOf(const ImageComparison& comparison) {
  std::vector<HeldDofFound> held;
  if (!comparison.joint.IsUsable()) return held;
  const ProcessSet& processes = comparison.joint.processes;
  int slot = 0;
  for (const Dof dof : kAllDofs) {
    if (dof == comparison.comparison.dofs.front().dof) continue;
    held.push_back({dof, processes.wander[slot], processes.response_std[slot]});
    ++slot;
  }
  return held;
}

ImageComparison CompareOnImages(const MarkerLogs& logs, const ImageComparisonOptions& options) {
  ImageComparison result;
  result.comparison.log_name = logs.logs.front().name;
  for (size_t i = 1; i < logs.logs.size(); ++i) {
    result.comparison.log_name += ", " + logs.logs[i].name;
  }
  result.comparison.remarks = logs.remarks;
  result.moved_markers = logs.moved_markers;
  DofComparison dof;
  dof.dof = logs.dof;
  const JoinedSignals by_camera = JoinSignals(logs.logs, logs.dof, Source::kCamera);
  const Signals& camera = by_camera.all;
  const bool has_velocity = std::all_of(logs.logs.begin(), logs.logs.end(), [&](const Log& log) {
    return HasVelocity(log, logs.dof);
  });
  JoinedSignals scored =
      has_velocity ? JoinSignals(logs.logs, logs.dof, Source::kPoseEstimator) : by_camera;
  dof.scored = std::move(scored.all);
  dof.log_of_train = std::move(scored.log_of_train);
  dof.log_of_held_out = std::move(scored.log_of_held_out);
  dof.findings = CheckLogs(logs.logs, dof.scored);
  dof.remarks = dof.scored.remarks;
  if (has_velocity) {
    dof.remarks.insert(dof.remarks.end(), camera.remarks.begin(), camera.remarks.end());
  }
  dof.remarks.push_back(
      has_velocity
          ? "Velocity MAE and NMAE are against velocity.csv. No row was fitted to it."
          : "There is no velocity.csv. Velocity MAE and NMAE are against the derivative of "
            "the PnP poses and contain its noise.");
  JointOptions joint = options.identification.joint;
  for (const Family family : kSignalFamilies) {
    dof.rows.push_back(Identify(camera, dof.scored, family, options.identification));
    const Identification& row = dof.rows.back();
    if (family != options.initial_guess) continue;
    if (row.is_usable) {
      joint.initial_guess = row.fitted.model;
    } else {
      result.joint.message = fmt::format(
          "The initial guess by {} is not a usable model: {}", Name(family), row.message);
    }
  }
  const bool can_start = !options.initial_guess || joint.initial_guess;
  if (can_start) result.joint = FitJoint(logs.input, joint);
  dof.rows.push_back(
      OrBestGuess(IdentificationOf(result.joint, dof.scored), dof.rows, dof.scored.source));
  std::ranges::move(CheckRows(dof.rows, BodyOf(logs.logs)), std::back_inserter(dof.findings));
  dof.findings = WarningsFirst(std::move(dof.findings));
  result.comparison.dofs.push_back(std::move(dof));
  return result;
}

}  // namespace fathom
