// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/check/finding_json.h"

#include <nlohmann/json.hpp>

namespace fathom {

nlohmann::ordered_json JsonOf(const std::vector<Finding>& findings) {
  auto list = nlohmann::ordered_json::array();
  for (const Finding& finding : findings) {
    list.push_back({{"severity", finding.severity == Severity::kWarning ? "red" : "yellow"},
                    {"code", finding.code},
                    {"sentence", finding.sentence}});
  }
  return list;
}

}  // namespace fathom
