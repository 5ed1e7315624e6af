// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/comparison.h"

#include "fathom/base/input_error.h"
#include "fathom/check/log_check.h"
#include "fathom/comparison/check_rows.h"
#include "fathom/comparison/joint_identification.h"
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
void AddJointRow(const Log& log, const ComparisonOptions& options, DofComparison* result) {
  if (!IsAmong(options.families, Family::kJoint)) return;
  const bool is_default = options.families.empty();
  const bool has_camera = IsAmong(options.sources, Source::kCamera);
  if (is_default && (!has_camera || !log.detections || !log.pose)) return;
  if (!has_camera) {
    throw InputError(
        "the family joint takes the corners that a camera saw, expected the source camera with "
        "it.");
  }
  std::vector<std::string> remarks;
  try {
    result->rows.push_back(
        IdentifyJointly({log}, result->scored, options.identification, &remarks));
  } catch (const InputError& error) {
    if (!is_default) throw;
    remarks = {std::string("left out: ") + error.what()};
  }
  for (const std::string& remark : remarks) result->remarks.push_back("Joint, camera: " + remark);
}

// The sources that a log has for `dof`, the best one first. Throws InputError if there is none.
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

DofComparison CompareAlong(Dof dof, const Log& log, const ComparisonOptions& options) {
  const std::vector<Source> available = RequireSources(log, dof);
  DofComparison result;
  result.dof = dof;
  result.scored = SignalsOf(log, dof, {.source = available.front()});
  result.findings = CheckLogs({&log, 1}, result.scored);
  result.remarks = result.scored.remarks;
  bool is_all_held_out = true;
  for (const Source source : options.sources.empty() ? available : options.sources) {
    Signals signals = result.scored;
    if (source != available.front()) {
      signals = SignalsOf(log, dof, {.source = source});
      result.remarks.insert(result.remarks.end(), signals.remarks.begin(), signals.remarks.end());
    }
    is_all_held_out = is_all_held_out && IsAllHeldOut(signals);
    for (const Family family : kSignalFamilies) {
      if (!IsAmong(options.families, family)) continue;
      result.rows.push_back(Identify(signals, result.scored, family, options.identification));
    }
  }
  if (is_all_held_out) {
    throw InputError(fmt::format("{}: {}", FileOf(log, "log.yaml"), kAllIsHeldOut));
  }
  AddJointRow(log, options, &result);
  std::ranges::move(CheckRows(result.rows, BodyOf({&log, 1})), std::back_inserter(result.findings));
  result.findings = WarningsFirst(std::move(result.findings));
  return result;
}

}  // namespace

Comparison Compare(const Log& log, const ComparisonOptions& options) {
  Comparison comparison;
  comparison.log_name = log.name;
  comparison.remarks = TextsOf(log.remarks);
  const std::vector<Dof>& dofs = options.dofs.empty() ? log.dofs : options.dofs;
  if (dofs.empty()) {
    throw InputError(
        fmt::format("{}: log.yaml names no dof; say which with --dofs.", log.path.string()));
  }
  for (const Dof dof : dofs) comparison.dofs.push_back(CompareAlong(dof, log, options));
  return comparison;
}

}  // namespace fathom
