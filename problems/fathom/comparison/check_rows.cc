// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/check_rows.h"

#include "fathom/check/inertia_check.h"
#include "fathom/comparison/comparison_page.h"

#include <cmath>

#include <fmt/format.h>

namespace fathom {

void CheckRows(std::optional<double> mass, DofComparison* comparison) {
  if (!mass) return;
  for (const Identification& row : comparison->rows) {
    if (!row.is_usable) continue;
    const double std = std::sqrt(row.fitted.covariance(kInertia, kInertia));
    auto finding = CheckInertia(comparison->dof, row.fitted.model.inertia, std, *mass);
    if (!finding) continue;
    finding->sentence = fmt::format("{}: {}", ModelName(row), finding->sentence);
    comparison->findings.push_back(*std::move(finding));
  }
  comparison->findings = WarningsFirst(std::move(comparison->findings));
}

}  // namespace fathom
