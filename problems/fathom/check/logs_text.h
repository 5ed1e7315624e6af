// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/check/logs_checkup.h"
#include "fathom/report/page_origin.h"
#include "fathom/report/table.h"

#include <span>
#include <string>

namespace fathom {

// Several logs for a terminal: a row for each (FormatCheckedLogs), its findings, for each DOF the
// standard deviation that each log alone leaves its parameters, its share of what all know, and
// what to hold out, and which DOFs are not compared.
std::string FormatLogs(const std::vector<CheckedLog>& logs,
                       std::span<const DofOfLogs> dofs,
                       TableFormat format);

// The same as JSON, schema "fathom-check-logs-1"; docs/check.md.
std::string FormatLogsJson(const std::vector<CheckedLog>& logs, std::span<const DofOfLogs> dofs);

// The same as a page, with the estimates of each log as dots.
std::string RenderLogsPage(const std::vector<CheckedLog>& logs,
                           std::span<const DofOfLogs> dofs,
                           const PageOrigin& origin);

}  // namespace fathom
