// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/findings/finding.h"

#include <vector>

namespace fathom {

// [{severity, code, sentence, where: {file, axis, from, to}}], as every file has them: severity
// "red" for a warning, else "yellow"; `where` only of a finding that has a place. `Json` is
// nlohmann's, which this header is spared.
template <typename Json>
Json JsonOf(const std::vector<Finding>& findings) {
  Json list = Json::array();
  for (const Finding& finding : findings) {
    list.push_back({{"severity", finding.severity == Severity::kWarning ? "red" : "yellow"},
                    {"code", finding.code},
                    {"sentence", finding.sentence}});
    if (const auto& where = finding.where) {
      list.back()["where"] = {{"file", where->file},
                              {"axis", where->axis},
                              {"from", where->time.from},
                              {"to", where->time.to}};
    }
  }
  return list;
}

}  // namespace fathom
