// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/check_rows.h"

#include "fathom/identification/identification_text.h"

#include <utility>

#include <fmt/format.h>

namespace fathom {

std::vector<Finding> CheckRows(std::span<const Identification> rows,
                               const std::optional<Body>& body) {
  std::vector<Finding> findings;
  for (const Identification& row : rows) {
    if (!row.is_usable) continue;
    auto finding = CheckInertia(row.fitted, body);
    if (!finding) continue;
    finding->sentence = fmt::format("{}: {}", ModelName(row), finding->sentence);
    findings.push_back(*std::move(finding));
  }
  return findings;
}

}  // namespace fathom
