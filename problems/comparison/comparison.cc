// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/comparison.h"

#include "fathom/base/input_error.h"

#include <algorithm>

#include <fmt/format.h>

namespace fathom {

std::vector<Source> SourcesOf(const Log& log, Dof dof) {
  std::vector<Source> sources;
  if (log.velocity && log.velocity->Find(VelocityColumn(dof)) != nullptr) {
    sources.push_back(Source::kPoseEstimator);
  }
  if (log.pose) sources.push_back(Source::kCamera);
  return sources;
}

Comparison Compare(const Log& log, const ComparisonOptions& options) {
  Comparison comparison;
  comparison.log_name = log.name;
  comparison.remarks = log.remarks;
  const std::vector<Dof>& dofs = options.dofs.empty() ? log.dofs : options.dofs;
  if (dofs.empty()) {
    throw InputError(
        fmt::format("{}: log.yaml names no dof; say which with --dofs.", log.path.string()));
  }
  for (const Dof dof : dofs) {
    const std::vector<Source> available = SourcesOf(log, dof);
    if (available.empty()) {
      throw InputError(
          fmt::format("{}: nothing measures {}: velocity.csv has no column '{}' and there is no "
                      "pose.csv.",
                      log.path.string(),
                      Name(dof),
                      VelocityColumn(dof)));
    }
    DofComparison result;
    result.dof = dof;
    result.scored = SignalsOf(log, dof, {.source = available.front()});
    result.findings = CheckSanity(result.scored);
    result.remarks = result.scored.remarks;
    for (const Source source : options.sources.empty() ? available : options.sources) {
      Signals signals = result.scored;
      if (source != available.front()) {
        signals = SignalsOf(log, dof, {.source = source});
        result.remarks.insert(result.remarks.end(), signals.remarks.begin(), signals.remarks.end());
      }
      for (const Family family : kAllFamilies) {
        const auto& wanted = options.families;
        if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), family) == wanted.end()) {
          continue;
        }
        result.rows.push_back(Identify(signals, result.scored, family, options.identification));
      }
    }
    comparison.dofs.push_back(std::move(result));
  }
  return comparison;
}

}  // namespace fathom
