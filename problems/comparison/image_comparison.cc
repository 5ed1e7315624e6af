// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/image_comparison.h"

#include "fathom/base/input_error.h"
#include "fathom/comparison/joint_identification.h"
#include "fathom/joint_refinement/first_guess.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

// The signals of all logs as one, a segment each or more.
Signals SignalsOfAll(const MarkerLogs& logs, Source source) {
  const SignalsOptions options = {.source = source};
  Signals all = SignalsOf(logs.logs.front(), logs.dof, options);
  for (size_t i = 1; i < logs.logs.size(); ++i) {
    Append(SignalsOf(logs.logs[i], logs.dof, options), &all);
  }
  return all;
}

bool HasVelocity(const Log& log, Dof dof) {
  return log.velocity && log.velocity->Find(VelocityColumn(dof)) != nullptr;
}

}  // namespace

std::vector<HeldCoordinateFound> HeldCoordinatesOf(const ImageComparison& comparison) {
  constexpr std::array<const char*, 6> kNames = {"x", "y", "z", "roll", "pitch", "yaw"};
  std::vector<HeldCoordinateFound> held;
  if (!comparison.joint.IsUsable()) return held;
  const ProcessSet& processes = comparison.joint.processes;
  for (int i = 0, j = 0; i < 6; ++i) {
    if (i == comparison.excited) continue;
    held.push_back(
        {kNames[i], i < 3 ? "m" : "rad", processes.wander[j], processes.response_std[j]});
    ++j;
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
  DofComparison dof;
  dof.dof = logs.dof;
  const Signals camera = SignalsOfAll(logs, Source::kCamera);
  const bool has_velocity = std::all_of(logs.logs.begin(), logs.logs.end(), [&](const Log& log) {
    return HasVelocity(log, logs.dof);
  });
  dof.scored = has_velocity ? SignalsOfAll(logs, Source::kPoseEstimator) : camera;
  dof.findings = CheckSanity(dof.scored);
  dof.remarks = dof.scored.remarks;
  if (has_velocity) {
    dof.remarks.insert(dof.remarks.end(), camera.remarks.begin(), camera.remarks.end());
  }
  dof.remarks.push_back(has_velocity
                            ? "MAE and NMAE are against velocity.csv, which no row was fitted to."
                            : "MAE and NMAE are against the derivative of the PnP poses, whose "
                              "noise is in all of them: there is no velocity.csv.");
  JointOptions joint = options.identification.joint;
  for (const Family family : kSignalFamilies) {
    dof.rows.push_back(Identify(camera, dof.scored, family, options.identification));
    const Identification& row = dof.rows.back();
    if (family != options.initial_guess) continue;
    if (!row.is_usable) {
      throw InputError(
          fmt::format("the first guess by {} is no usable model: {}", Name(family), row.message));
    }
    joint.initial_guess = row.fitted.model;
  }
  result.excited = ExcitedCoordinateOf(logs.dof, logs.input.runs).index;
  result.joint = FitJoint(logs.input, joint);
  dof.rows.push_back(IdentificationOf(result.joint, dof.scored));
  result.comparison.dofs.push_back(std::move(dof));
  return result;
}

}  // namespace fathom
