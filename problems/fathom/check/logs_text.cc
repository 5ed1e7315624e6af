// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/check/logs_text.h"

#include "fathom/base/files/json_text.h"
#include "fathom/base/short_number.h"
#include "fathom/check/checkup_json.h"
#include "fathom/check/checkup_text.h"
#include "fathom/check/left_out_dofs.h"
#include "fathom/check/listed_findings.h"
#include "fathom/check/logs_verdict.h"
#include "fathom/report/format_value.h"
#include "fathom/report/page.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kCaption =
    "How well each log alone knows a parameter: the standard deviation, and in brackets the log's "
    "share of what all logs know. The last row is what they know together, if they are of one "
    "vehicle and agree.";

const FittedModel& ModelOf(const std::vector<CheckedLog>& logs, std::size_t log_index, Dof dof) {
  return FindDof(logs[log_index].checkup, dof)->model->fitted;
}

std::string UnitOf(const std::vector<CheckedLog>& logs, const DofOfLogs& of_dof, int parameter) {
  const FittedModel& any = ModelOf(logs, of_dof.log_indices.front(), of_dof.dof);
  return ParameterUnit(parameter, any.dof, any.force_unit);
}

double StdOf(const Eigen::MatrixXd& covariance, int parameter) {
  return std::sqrt(covariance(parameter, parameter));
}

std::string FindingLines(const CheckedLog& log) {
  std::string text;
  for (const ListedFinding& finding : ListedFindings(log.checkup)) {
    text += fmt::format("{:<7} {:<17} {}\n",
                        finding.severity == Severity::kWarning ? "red" : "yellow",
                        finding.code,
                        finding.sentence);
  }
  return text.empty() ? "" : fmt::format("\n{}\n{}", log.path, text);
}

constexpr const char* kMoreOfEachLog =
    "fathom_check of one log alone says what its findings do to a model, and what to do.";

Table InformationTable(const std::vector<CheckedLog>& logs, const DofOfLogs& of_dof) {
  Table table;
  table.columns = {{"log"}};
  for (int p = 0; p < kNumParameters; ++p) {
    table.columns.push_back(
        {fmt::format(
             "{} [{}]", kParameterInfo[static_cast<std::size_t>(p)].name, UnitOf(logs, of_dof, p)),
         true,
         std::max(0, p - kQuadraticDamping)});
  }
  for (std::size_t k = 0; k < of_dof.log_indices.size(); ++k) {
    const std::size_t i = of_dof.log_indices[k];
    TableRow row = {{logs[i].path}};
    for (int p = 0; p < kNumParameters; ++p) {
      const double std = StdOf(ModelOf(logs, i, of_dof.dof).covariance, p);
      std::string cell = ShortNumber(std, 2);
      if (of_dof.information) {
        const double share = of_dof.information->share(static_cast<Eigen::Index>(k), p);
        cell += fmt::format(" ({:.0f} %)", 100.0 * share);
      }
      row.cells.push_back(std::move(cell));
    }
    table.rows.push_back(std::move(row));
  }
  if (!of_dof.information) return table;
  TableRow all = {{"all together"}};
  for (int p = 0; p < kNumParameters; ++p) {
    all.cells.push_back(ShortNumber(StdOf(of_dof.information->covariance, p), 2));
  }
  table.rows.push_back(std::move(all));
  return table;
}

std::vector<std::string> SplitSentences(const std::vector<CheckedLog>& logs,
                                        const DofOfLogs& of_dof) {
  std::vector<std::string> sentences;
  if (of_dof.held_out.empty()) return sentences;
  sentences.emplace_back("To judge the model on data that it has not seen, add to log.yaml:");
  for (const LogHeldOut& one : of_dof.held_out) {
    // Rounded outwards, so that no row of the whole log is left.
    sentences.push_back(fmt::format("of {}: held_out: [{:.1f}, {:.1f}]",
                                    logs[one.log_index].path,
                                    std::floor(10.0 * one.time.from) / 10.0,
                                    std::ceil(10.0 * one.time.to) / 10.0));
  }
  return sentences;
}

ParameterPanel PanelOf(const std::vector<CheckedLog>& logs, const DofOfLogs& of_dof, int p) {
  ParameterPanel panel;
  panel.name = kParameterInfo[static_cast<std::size_t>(p)].name;
  std::ranges::replace(panel.name, '_', ' ');
  panel.unit = UnitOf(logs, of_dof, p);
  panel.lower_bound = kParameterInfo[static_cast<std::size_t>(p)].lower_bound;
  for (const std::size_t i : of_dof.log_indices) {
    const FittedModel& fitted = ModelOf(logs, i, of_dof.dof);
    panel.estimates.push_back(
        {logs[i].path, ToVector(fitted.model)[p], StdOf(fitted.covariance, p)});
  }
  return panel;
}

Json ParameterJson(const std::vector<CheckedLog>& logs, const DofOfLogs& of_dof, int p) {
  Json of_logs = Json::array();
  for (std::size_t k = 0; k < of_dof.log_indices.size(); ++k) {
    const std::size_t i = of_dof.log_indices[k];
    of_logs.push_back(
        {{"log", logs[i].path}, {"std", StdOf(ModelOf(logs, i, of_dof.dof).covariance, p)}});
    if (!of_dof.information) continue;
    of_logs.back()["share"] = of_dof.information->share(static_cast<Eigen::Index>(k), p);
  }
  return {{"name", kParameterInfo[static_cast<std::size_t>(p)].name},
          {"unit", UnitOf(logs, of_dof, p)},
          {"std", of_dof.information ? Json(StdOf(of_dof.information->covariance, p)) : Json()},
          {"logs", std::move(of_logs)}};
}

}  // namespace

std::string FormatLogs(const std::vector<CheckedLog>& logs,
                       std::span<const DofOfLogs> dofs,
                       TableFormat format) {
  std::string text = LogsVerdict(logs, dofs) + "\n\n" + FormatCheckedLogs(logs, format);
  std::string findings;
  for (const CheckedLog& log : logs) findings += FindingLines(log);
  if (!findings.empty()) text += findings + kMoreOfEachLog + "\n";
  for (const DofOfLogs& of_dof : dofs) {
    text += fmt::format(
        "\n{}\n{}\n{}", Name(of_dof.dof), kCaption, format(InformationTable(logs, of_dof)));
    for (const std::string& sentence : Disagreements(of_dof)) text += sentence + "\n";
    for (const std::string& sentence : SplitSentences(logs, of_dof)) text += sentence + "\n";
  }
  const std::vector<std::string> left_out = LeftOutDofs(logs);
  if (!left_out.empty()) text += "\n";
  for (const std::string& sentence : left_out) text += sentence + "\n";
  return text;
}

std::string FormatLogsJson(const std::vector<CheckedLog>& logs, std::span<const DofOfLogs> dofs) {
  Json of_logs = Json::array(), of_dofs = Json::array();
  for (const CheckedLog& log : logs) {
    Json one = Json::parse(FormatCheckupJson(log.checkup));
    one["path"] = log.path;
    of_logs.push_back(std::move(one));
  }
  for (const DofOfLogs& of_dof : dofs) {
    Json parameters = Json::array(), held_out = Json::array();
    for (int p = 0; p < kNumParameters; ++p) {
      parameters.push_back(ParameterJson(logs, of_dof, p));
    }
    for (const LogHeldOut& one : of_dof.held_out) {
      held_out.push_back(
          {{"log", logs[one.log_index].path}, {"from", one.time.from}, {"to", one.time.to}});
    }
    of_dofs.push_back({{"dof", Name(of_dof.dof)},
                       {"parameters", std::move(parameters)},
                       {"disagreements", Disagreements(of_dof)},
                       {"held_out", std::move(held_out)}});
  }
  const Json json = {{"schema", "fathom-check-logs-1"},
                     {"verdict", LogsVerdict(logs, dofs)},
                     {"logs", std::move(of_logs)},
                     {"dofs", std::move(of_dofs)},
                     {"left_out", LeftOutDofs(logs)}};
  return JsonText(json);
}

std::string RenderLogsPage(const std::vector<CheckedLog>& logs,
                           std::span<const DofOfLogs> dofs,
                           const PageOrigin& origin) {
  Page page;
  page.title = fmt::format("Check of {} logs", logs.size());
  page.lead = {LogsVerdict(logs, dofs)};
  page.footer = kColourKey;
  page.origin = origin;
  PageSection findings;
  findings.heading = "Findings";
  findings.tables = {CheckedLogsTable(logs)};
  for (const CheckedLog& log : logs) {
    for (const ListedFinding& finding : ListedFindings(log.checkup)) {
      std::vector<std::string>& to =
          finding.severity == Severity::kWarning ? findings.warnings : findings.text;
      to.push_back(fmt::format("{}: {}: {} ({})",
                               finding.severity == Severity::kWarning ? "Red" : "Yellow",
                               log.path,
                               finding.sentence,
                               finding.code));
    }
  }
  if (!findings.warnings.empty() || !findings.text.empty()) {
    findings.text.emplace_back(kMoreOfEachLog);
  }
  for (std::string& sentence : LeftOutDofs(logs)) findings.text.push_back(std::move(sentence));
  page.sections.push_back(std::move(findings));
  for (const DofOfLogs& of_dof : dofs) {
    PageSection section;
    section.heading = std::string(Name(of_dof.dof));
    section.warnings = Disagreements(of_dof);
    section.text = SplitSentences(logs, of_dof);
    Table table = InformationTable(logs, of_dof);
    table.caption = kCaption;
    section.tables = {std::move(table)};
    for (int p = 0; p < kNumParameters; ++p) {
      section.parameter_panels.push_back(PanelOf(logs, of_dof, p));
    }
    page.sections.push_back(std::move(section));
  }
  return RenderPage(page);
}

}  // namespace fathom
