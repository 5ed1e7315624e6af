// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/check/log_checkup.h"
#include "fathom/findings/finding.h"

#include <string>
#include <vector>

namespace fathom {

// What a log is found to have, once, however many of its DOFs have it.
struct ListedFinding {
  Severity severity = Severity::kNote;
  std::string code;
  std::string sentence;  // begins with these DOFs, if there are any: "surge, yaw: ..."
};

// Of the log, then of its DOFs; warnings first.
std::vector<ListedFinding> ListedFindings(const LogCheckup& checkup);

}  // namespace fathom
