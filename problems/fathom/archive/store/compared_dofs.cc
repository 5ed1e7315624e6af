// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/store/compared_dofs.h"

#include <cmath>
#include <map>
#include <set>

namespace fathom {

bool IsOfSeveralDofs(const std::string& dofs) { return dofs.find(',') != std::string::npos; }

std::string CoupledDofsCompared(const std::vector<DiveFitRow>& dive_fits,
                                const std::string& vehicle) {
  std::set<std::string> dives;
  std::map<std::string, std::set<std::string>> dives_of;
  for (const DiveFitRow& row : dive_fits) {
    if (row.vehicle != vehicle || !row.usable || !std::isfinite(row.value)) continue;
    dives.insert(row.dive);
    if (IsOfSeveralDofs(row.dof)) dives_of[row.dof].insert(row.dive);
  }
  std::string best;
  std::size_t most = 0;
  for (const auto& [dofs, own] : dives_of) {
    if (own.size() <= most) continue;
    most = own.size();
    best = dofs;
  }
  return most >= kFewestDivesForChange && 4 * most >= 3 * dives.size() ? best : "";
}

bool AreCompared(const std::string& dofs, const std::string& coupled) {
  if (IsOfSeveralDofs(dofs)) return dofs == coupled;
  return ("," + coupled + ",").find("," + dofs + ",") == std::string::npos;
}

}  // namespace fathom
