// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/explain_first.h"

#include <algorithm>

#include <fmt/format.h>

namespace fathom {

std::string ExplainFirst(const std::vector<Finding>& findings) {
  const auto num_red = std::ranges::count(findings, Severity::kWarning, &Finding::severity);
  if (num_red == 0) return "";
  return fmt::format(
      "{} to be explained before a model of this log can be believed.",
      num_red == 1 ? "One red finding has" : fmt::format("{} red findings have", num_red));
}

}  // namespace fathom
