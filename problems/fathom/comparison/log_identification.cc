// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/log_identification.h"

#include "fathom/base/input_error.h"
#include "fathom/check/inertia_check.h"
#include "fathom/check/log_check.h"
#include "fathom/comparison/joint_identification.h"
#include "fathom/signal/joined_signals.h"
#include "fathom/signal/sources/log_column.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

// Of an inertia that contradicts the vehicle's mass.
void AddInertiaFinding(std::optional<double> mass, LogIdentification* identified) {
  const FittedModel& fitted = identified->result.fitted;
  if (!mass || !identified->result.is_usable) return;
  const double std = std::sqrt(fitted.covariance(kInertia, kInertia));
  auto finding = CheckInertia(fitted.dof, fitted.model.inertia, std, *mass);
  if (!finding) return;
  identified->findings.push_back(*std::move(finding));
  identified->findings = WarningsFirst(std::move(identified->findings));
}

}  // namespace

std::vector<std::string> LogIdentificationOptions::Problems() const {
  std::vector<std::string> problems;
  if (family == Family::kJoint && source == Source::kPoseEstimator) {
    problems.emplace_back(
        "source: is 'pose_estimator', expected camera: the family joint takes the corners that a "
        "camera saw");
  }
  return problems;
}

LogIdentification IdentifyFromLogs(std::vector<Log> logs, const LogIdentificationOptions& options) {
  if (const auto problems = options.Problems(); !problems.empty()) {
    throw InputError(problems.front() + ".");
  }
  if (logs.empty()) throw InputError("An identification needs at least one log.");
  const bool is_joint = options.family == Family::kJoint;
  LogIdentification identified;
  identified.signals =
      JoinSignals(logs, options.dof, is_joint ? Source::kCamera : options.source).all;
  const Signals& signals = identified.signals;
  if (IsAllHeldOut(signals)) {
    throw InputError(fmt::format("{}: {}", FileOf(logs.front(), "log.yaml"), kAllIsHeldOut));
  }
  identified.findings = CheckLogs(logs, signals);
  const std::optional<double> mass = MassOf(logs);
  if (!is_joint) logs = {};  // a long one takes as much memory as its signals
  if (is_joint) {
    identified.result =
        IdentifyJointly(std::move(logs), signals, options.identification, &identified.remarks);
  } else {
    identified.result = Identify(signals, signals, options.family, options.identification);
  }
  AddInertiaFinding(mass, &identified);
  return identified;
}

}  // namespace fathom
