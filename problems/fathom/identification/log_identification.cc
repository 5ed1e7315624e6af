// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/identification/log_identification.h"

#include "fathom/base/input_error.h"
#include "fathom/findings/inertia_check.h"
#include "fathom/findings/log_check.h"
#include "fathom/identification/joint_identification.h"
#include "fathom/identification/log_agreement.h"
#include "fathom/signal/joined_signals.h"
#include "fathom/signal/sources/log_column.h"
#include "fathom/simulate/free_run.h"
#include "fathom/vehicle/files/thruster_shares.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

// The offsets of the fit by log, of those that have training data.
std::vector<LogOffset> OffsetsOf(const Identification& result,
                                 const std::vector<std::string>& names,
                                 const JoinedSignals& joined) {
  const std::vector<std::size_t>& log_of_train = joined.log_of_train;
  const OffsetSharing sharing = OneOffsetPerLog(log_of_train);
  std::vector<LogOffset> offsets;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto first = std::find(log_of_train.begin(), log_of_train.end(), k);
    if (first == log_of_train.end()) continue;
    const auto& [value, std] = result.offsets[sharing.At(first - log_of_train.begin())];
    UncoupledModel<double> model = result.fitted.model;
    model.buoyancy = value;
    const Signals own = TrainingOf(k, joined);
    offsets.push_back({names[k], value, std, FiguresOf({model}, own.train)});
  }
  return offsets;
}

}  // namespace

std::vector<std::string> LogIdentificationOptions::Problems() const {
  std::vector<std::string> problems;
  if (family == Family::kJoint && source == Source::kPoseEstimator) {
    problems.emplace_back(
        "source: is 'pose_estimator', expected camera: the family joint takes the corners that a "
        "camera saw");
  }
  if (offset == OffsetScope::kPerLog && family != Family::kOutputError) {
    problems.push_back(
        fmt::format("offset: is per_log, expected shared: the family {} has one offset in all logs",
                    Name(family)));
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
  JoinedSignals joined =
      JoinSignals(logs, options.dof, is_joint ? Source::kCamera : options.source);
  const Signals& signals = joined.all;
  if (IsAllHeldOut(signals)) {
    throw InputError(fmt::format("{}: {}", FileOf(logs.front(), "log.yaml"), kAllIsHeldOut));
  }
  identified.findings = CheckLogs(logs, signals);
  const std::optional<Body> body = BodyOf(logs);
  std::vector<std::string> names;
  for (const Log& log : logs) names.push_back(log.path.filename().string());
  std::map<std::string, double> thruster_shares = ThrusterSharesOf(logs, signals.dof);
  if (!is_joint) logs = {};  // a long one takes as much memory as its signals
  if (is_joint) {
    identified.result =
        IdentifyJointly(std::move(logs), signals, options.identification, &identified.remarks);
  } else {
    const bool has_own_offsets = options.offset == OffsetScope::kPerLog;
    IdentificationOptions identification = options.identification;
    identification.output_error.offsets =
        has_own_offsets ? OneOffsetPerLog(joined.log_of_train) : OffsetSharing();
    Identification& result = identified.result;
    result = Identify(signals, signals, options.family, identification);
    if (has_own_offsets && result.is_usable) {
      identified.offsets = OffsetsOf(result, names, joined);
      std::string remark = RemarkOnOffsets(identified.offsets, result.fitted.force_unit);
      if (!remark.empty()) result.fitted.caveats.push_back(std::move(remark));
    }
    if (names.size() > 1) {
      identified.agreement =
          WidenByAgreement(names, joined, options.identification, &identified.result);
    }
  }
  identified.signals = std::move(joined.all);
  if (!identified.result.is_usable) return identified;
  identified.result.fitted.thruster_shares = std::move(thruster_shares);
  if (auto finding = CheckInertia(identified.result.fitted, body)) {
    identified.findings.push_back(*std::move(finding));
    identified.findings = WarningsFirst(std::move(identified.findings));
  }
  return identified;
}

}  // namespace fathom
