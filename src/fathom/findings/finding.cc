// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/finding.h"

#include <algorithm>

namespace fathom {

std::vector<Finding> WarningsFirst(std::vector<Finding> findings) {
  std::ranges::stable_sort(findings, [](const Finding& a, const Finding& b) {
    return a.severity == Severity::kWarning && b.severity != Severity::kWarning;
  });
  return findings;
}

bool Has(const std::vector<Finding>& findings, const std::string& code) {
  return std::ranges::any_of(findings, [&](const Finding& one) { return one.code == code; });
}

}  // namespace fathom
