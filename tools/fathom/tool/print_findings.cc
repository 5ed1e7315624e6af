// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/print_findings.h"

#include <cstdio>

namespace fathom {

void PrintWarnings(const std::vector<Finding>& findings) {
  for (const Finding& finding : findings) {
    if (finding.severity != Severity::kWarning) continue;
    std::fprintf(stderr, "WARNING: %s\n", finding.sentence.c_str());
  }
}

void PrintNotes(const std::vector<Finding>& findings) {
  for (const Finding& finding : findings) {
    if (finding.severity != Severity::kNote) continue;
    std::printf("note: %s\n", finding.sentence.c_str());
  }
}

}  // namespace fathom
