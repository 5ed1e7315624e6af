// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/check/finding.h"

#include <vector>

namespace fathom {

// [{severity, code, sentence}], as every file has them: severity "red" for a warning, else
// "yellow". `Json` is nlohmann's, which this header is spared.
template <typename Json>
Json JsonOf(const std::vector<Finding>& findings) {
  Json list = Json::array();
  for (const Finding& finding : findings) {
    list.push_back({{"severity", finding.severity == Severity::kWarning ? "red" : "yellow"},
                    {"code", finding.code},
                    {"sentence", finding.sentence}});
  }
  return list;
}

}  // namespace fathom
