// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/print_findings.h"

#include "fathom/tool/print_text.h"

#include <cstdio>

namespace fathom {

void PrintWarnings(const std::vector<Finding>& findings) {
  for (const Finding& finding : findings) {
    if (finding.severity != Severity::kWarning) continue;
    PrintText(stderr, "WARNING: " + finding.sentence + "\n");
  }
}

void PrintNotes(const std::vector<Finding>& findings) {
  for (const Finding& finding : findings) {
    if (finding.severity != Severity::kNote) continue;
    PrintText(stdout, "note: " + finding.sentence + "\n");
  }
}

}  // namespace fathom
