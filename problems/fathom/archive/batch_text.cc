// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/batch_text.h"

#include "fathom/archive/report/archive_sentences.h"
#include "fathom/base/files/path_text.h"
#include "fathom/base/plural.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

std::string DurationText(double seconds) {
  if (seconds < 100.0) return fmt::format("{:.0f} s", seconds);
  if (seconds < 6000.0) return fmt::format("{:.0f} min", seconds / 60.0);
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

std::string CountsText(const std::map<std::string, int>& counts) {
  std::vector<std::string> parts;
  for (const auto& [kind, count] : counts) parts.push_back(fmt::format("{} {}", count, kind));
  return fmt::format("{}", fmt::join(parts, ", "));
}

int Sum(const std::map<std::string, int>& counts) {
  int sum = 0;
  for (const auto& [kind, count] : counts) sum += count;
  return sum;
}

std::string OtherFilesText(const std::map<std::string, int>& other_files,
                           const std::vector<NearlyLog>& nearly_logs) {
  const int sum = Sum(other_files);
  if (sum == 0) return "";
  const std::string nearly = NearlyLogsSentence(nearly_logs);
  return fmt::format("{} {}: {}\n{}",
                     Plural(static_cast<std::size_t>(sum), "other file"),
                     sum == 1 ? "that is no log" : "that are no logs",
                     CountsText(other_files),
                     nearly.empty() ? "" : nearly + "\n");
}

// In double quotes where a cell needs them.
std::string Cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string Cell(double number) { return std::isfinite(number) ? fmt::format("{}", number) : ""; }

}  // namespace

std::string PaceText(const BatchProgress& progress, double seconds) {
  std::string text;
  if (progress.done > 0 && seconds > 1.0) {
    const double each = seconds / static_cast<double>(progress.done);
    const double left = each * static_cast<double>(progress.total - progress.done);
    text = fmt::format(", {:.3g} a minute, {} left", 60.0 / each, DurationText(left));
  }
  if (!progress.last_failure.empty()) text += "; last failure: " + progress.last_failure;
  return text;
}

std::string FormatSummary(const BatchSummary& summary, const Tables& tables) {
  std::string text;
  // A part of many knows no dives.
  if (!summary.dives.empty()) {
    for (const std::string& sentence : ChangeSentences(tables)) text += sentence + "\n";
    const std::string without = DivesWithoutFitSentence(tables);
    if (!without.empty()) text += without + "\n";
  }
  std::vector<std::string> states;
  std::size_t num_logs = 0;
  for (const auto& [state, count] : summary.states) {
    states.push_back(fmt::format("{} {}", count, Name(state)));
    num_logs += static_cast<std::size_t>(count);
  }
  text += fmt::format(
      "{}{}: {}\n",
      Plural(num_logs, "log"),
      summary.dives.empty() ? "" : fmt::format(" in {}", Plural(summary.dives.size(), "dive")),
      states.empty() ? "nothing found" : fmt::format("{}", fmt::join(states, ", ")));
  text += fmt::format(
      "{} run now, {} done before\n", Plural(summary.num_run, "log"), num_logs - summary.num_run);
  if (const std::string coupled = CoupledSentence(tables); !coupled.empty()) text += coupled + "\n";
  if (const std::string out = LeftOutSentence(tables); !out.empty()) text += out + "\n";
  text += OtherFilesText(summary.other_files, summary.nearly_logs);
  bool is_first = true;
  for (const LogRow& row : tables.logs) {
    if (row.status == "ok") continue;
    if (std::exchange(is_first, false)) text += "\n";
    text += fmt::format("{}: {}: {}\n", row.path, row.status, row.message);
  }
  return text;
}

ArchiveReport ReportOf(const BatchOptions& options,
                       const BatchSummary& summary,
                       Tables tables,
                       PageOrigin origin) {
  ArchiveReport report;
  report.archive = PathText(options.archive);
  report.origin = std::move(origin);
  report.origin.command = CleanText(report.origin.command);
  report.tables = std::move(tables);
  report.dives = summary.dives;
  report.other_files = summary.other_files;
  report.nearly_logs = summary.nearly_logs;
  const std::string folder = options.pages.filename().string();
  for (const auto& [log_and_dof, page] : summary.pages) {
    report.pages[log_and_dof] = folder + "/" + page;
  }
  return report;
}

std::string FormatPlan(const BatchPlan& plan, const std::string& version) {
  std::string text = fmt::format("{}, {} to do\n", Plural(plan.num_logs, "log"), plan.num_to_do);
  int known = 0;
  for (const auto& [done_by, count] : plan.done_by_version) {
    known += count;
    text += done_by == version ? fmt::format("{} changed, or done with other options\n",
                                             Plural(static_cast<std::size_t>(count), "log"))
                               : fmt::format("{} done by version {}, now {}\n",
                                             Plural(static_cast<std::size_t>(count), "log"),
                                             done_by,
                                             version);
  }
  const auto fresh = plan.num_to_do - static_cast<std::size_t>(known);
  if (fresh > 0) text += fmt::format("{} new\n", Plural(fresh, "log"));
  return text + OtherFilesText(plan.other_files, plan.nearly_logs);
}

std::string FormatFitsCsv(const std::vector<FitRow>& fits) {
  std::string csv = "log,dof,family,source,usable,parameter,value,std,unit,message\n";
  for (const FitRow& row : fits) {
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{}\n",
                       Cell(row.log),
                       Cell(row.dof),
                       row.family,
                       row.source,
                       row.usable ? 1 : 0,
                       row.parameter,
                       Cell(row.value),
                       Cell(row.std),
                       Cell(row.unit),
                       Cell(row.message));
  }
  return csv;
}

}  // namespace fathom
