// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/comparison.h"

#include "fathom/base/input_error.h"
#include "fathom/comparison/check_rows.h"
#include "fathom/findings/log_check.h"
#include "fathom/identification/joint_identification.h"
#include "fathom/identification/log_agreement.h"
#include "fathom/signal/joined_signals.h"
#include "fathom/signal/sources/choose_source.h"
#include "fathom/signal/sources/log_column.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

// Whether `value` is asked for; nothing asked for stands for everything.
template <typename T>
bool IsAmong(const std::vector<T>& wanted, T value) {
  return wanted.empty() || std::find(wanted.begin(), wanted.end(), value) != wanted.end();
}

// Its remarks are told from those on the signals by its name.
void AddJointRow(std::span<const Log> logs,
                 const ComparisonOptions& options,
                 DofComparison* result) {
  if (!IsAmong(options.families, Family::kJoint)) return;
  const bool is_default = options.families.empty();
  const bool has_camera = IsAmong(options.sources, Source::kCamera);
  const bool have_corners = std::ranges::all_of(
      logs, [](const Log& log) { return log.detections.has_value() && log.pose.has_value(); });
  if (is_default && (!has_camera || !have_corners)) return;
  if (!has_camera) {
    throw InputError(
        "the family joint takes the corners that a camera saw, expected the source camera with "
        "it.");
  }
  std::vector<std::string> remarks;
  try {
    result->rows.push_back(IdentifyJointly(
        {logs.begin(), logs.end()}, result->scored, options.identification, &remarks));
  } catch (const InputError& error) {
    if (!is_default) throw;
    remarks = {std::string("left out: ") + error.what()};
  }
  for (const std::string& remark : remarks) result->remarks.push_back("Joint, camera: " + remark);
}

// Throws InputError if there is none.
std::vector<Source> RequireSources(const Log& log, Dof dof) {
  std::vector<Source> available = SourcesOf(log, dof);
  if (available.empty()) {
    throw InputError(
        fmt::format("{}: nothing measures {}: velocity.csv has no column '{}' and there is no "
                    "pose.csv.",
                    log.path.string(),
                    Name(dof),
                    VelocityColumn(dof)));
  }
  return available;
}

// Keeps in `values` what `others` has too.
template <typename T>
void KeepCommon(const std::vector<T>& others, std::vector<T>* values) {
  std::erase_if(*values, [&](T value) { return std::ranges::find(others, value) == others.end(); });
}

// The sources that all logs have for `dof`, the best one first. Throws InputError if there is none.
std::vector<Source> CommonSources(std::span<const Log> logs, Dof dof) {
  std::vector<Source> common = RequireSources(logs.front(), dof);
  for (const Log& log : logs) KeepCommon(RequireSources(log, dof), &common);
  if (common.empty()) {
    throw InputError(
        fmt::format("{} and the logs beside it have no source of {} in common: some have it in "
                    "velocity.csv alone, others in pose.csv.",
                    logs.front().path.string(),
                    Name(dof)));
  }
  return common;
}

DofComparison CompareAlong(Dof dof, std::span<const Log> logs, const ComparisonOptions& options) {
  const std::vector<Source> available = CommonSources(logs, dof);
  std::vector<std::string> names;
  for (const Log& log : logs) names.push_back(log.path.filename().string());
  const JoinedSignals scored = JoinSignals(logs, dof, available.front());
  DofComparison result;
  result.dof = dof;
  result.scored = scored.all;
  result.log_of_train = scored.log_of_train;
  result.log_of_held_out = scored.log_of_held_out;
  result.findings = CheckLogs(logs, result.scored);
  result.remarks = result.scored.remarks;
  bool is_all_held_out = true;
  for (const Source source : options.sources.empty() ? available : options.sources) {
    JoinedSignals signals = scored;
    if (source != available.front()) {
      signals = JoinSignals(logs, dof, source);
      std::ranges::copy(signals.all.remarks, std::back_inserter(result.remarks));
    }
    is_all_held_out = is_all_held_out && IsAllHeldOut(signals.all);
    for (const Family family : kSignalFamilies) {
      if (!IsAmong(options.families, family)) continue;
      Identification& row = result.rows.emplace_back(
          Identify(signals.all, result.scored, family, options.identification));
      if (logs.size() > 1) WidenByAgreement(names, signals, options.identification, &row);
    }
  }
  if (is_all_held_out) {
    throw InputError(fmt::format("{}: {}", FileOf(logs.front(), "log.yaml"), kAllIsHeldOut));
  }
  AddJointRow(logs, options, &result);
  std::ranges::move(CheckRows(result.rows, BodyOf(logs)), std::back_inserter(result.findings));
  result.findings = WarningsFirst(std::move(result.findings));
  return result;
}

}  // namespace

std::vector<Dof> CommonDofs(std::span<const Log> logs) {
  std::vector<Dof> common = logs.front().dofs;
  for (const Log& log : logs) {
    if (log.dofs.empty()) {
      throw InputError(
          fmt::format("{}: log.yaml names no dof; say which with --dofs.", log.path.string()));
    }
    KeepCommon(log.dofs, &common);
  }
  if (common.empty()) {
    throw InputError(
        fmt::format("{} and the logs beside it name no dof in common; say which with --dofs.",
                    logs.front().path.string()));
  }
  return common;
}

Comparison Compare(std::span<const Log> logs, const ComparisonOptions& options) {
  if (logs.empty()) throw InputError("A comparison needs at least one log.");
  Comparison comparison;
  for (const Log& log : logs) {
    comparison.log_name += (comparison.log_name.empty() ? "" : ", ") + log.name;
    std::ranges::move(TextsOf(log.remarks), std::back_inserter(comparison.remarks));
  }
  for (const Dof dof : options.dofs.empty() ? CommonDofs(logs) : options.dofs) {
    comparison.dofs.push_back(CompareAlong(dof, logs, options));
  }
  return comparison;
}

}  // namespace fathom
