// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/check/checked_logs.h"

#include "fathom/check/checkup_verdict.h"

#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// "inertia passivity", or "-" where there is none.
std::string WordsOrDash(const std::set<std::string>& words) {
  return words.empty() ? "-" : fmt::format("{}", fmt::join(words, " "));
}

}  // namespace

Table CheckedLogsTable(const std::vector<CheckedLog>& logs) {
  Table table;
  table.columns = {{"log"}, {"DOFs"}, {"red"}, {"yellow", false, 1}};
  for (const CheckedLog& log : logs) {
    if (!log.message.empty()) {
      table.rows.push_back({{log.path, "-", "not readable", "-"}});
      continue;
    }
    const std::vector<std::string> usable = UsableDofs(log.checkup);
    std::set<std::string> red, yellow;
    for (const Finding& finding : AllFindings(log.checkup)) {
      (finding.severity == Severity::kWarning ? red : yellow).insert(finding.code);
    }
    table.rows.push_back({{log.path,
                           usable.empty() ? "-" : fmt::format("{}", fmt::join(usable, " ")),
                           WordsOrDash(red),
                           WordsOrDash(yellow)}});
  }
  return table;
}

std::string FormatCheckedLogs(const std::vector<CheckedLog>& logs, TableFormat format) {
  std::string text = format(CheckedLogsTable(logs));
  for (const CheckedLog& log : logs) {
    if (!log.message.empty())
      text += fmt::format("{} cannot be read as a log: {}\n", log.path, log.message);
  }
  return text;
}

}  // namespace fathom
