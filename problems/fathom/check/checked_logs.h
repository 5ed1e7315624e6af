// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/check/log_checkup.h"
#include "fathom/report/table.h"

#include <string>
#include <vector>

namespace fathom {

// A row for each log of an archive, or for what could not be opened.
struct CheckedLog {
  std::string path;
  std::string message;  // why it could not be checked; empty: it was
  LogCheckup checkup;
};

Table CheckedLogsTable(const std::vector<CheckedLog>& logs);

// The table, and below it why logs could not be read.
std::string FormatCheckedLogs(const std::vector<CheckedLog>& logs, TableFormat format);

}  // namespace fathom
