// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/check/listed_findings.h"

#include <algorithm>
#include <utility>

namespace fathom {
namespace {

struct SharedFinding {
  Finding finding;
  std::string dofs;  // "surge, yaw"; empty: it is of the log
};

void AddDof(const Finding& finding, Dof dof, std::vector<SharedFinding>* shared) {
  const auto same = std::ranges::find_if(*shared, [&](const SharedFinding& one) {
    return one.finding.code == finding.code && one.finding.sentence == finding.sentence;
  });
  const std::string name(Name(dof));
  if (same == shared->end()) {
    shared->push_back({finding, name});
  } else if (!same->dofs.empty()) {
    same->dofs += ", " + name;
  }
}

}  // namespace

std::vector<ListedFinding> ListedFindings(const LogCheckup& checkup) {
  std::vector<SharedFinding> shared;
  for (const Finding& finding : checkup.findings) shared.push_back({finding, ""});
  for (const DofCheckup& dof : checkup.dofs) {
    for (const Finding& finding : dof.findings) AddDof(finding, dof.dof, &shared);
  }
  std::ranges::stable_partition(
      shared, [](const SharedFinding& one) { return one.finding.severity == Severity::kWarning; });
  std::vector<ListedFinding> listed;
  for (const auto& [finding, dofs] : shared) {
    const std::string of_dofs = dofs.empty() ? "" : dofs + ": ";
    listed.push_back({finding.severity, finding.code, of_dofs + finding.sentence});
  }
  return listed;
}

}  // namespace fathom
