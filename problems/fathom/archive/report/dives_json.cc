// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/report/dives_json.h"

#include "fathom/archive/report/log_states.h"
#include "fathom/report/seven_digits.h"

#include <cctype>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using nlohmann::json;

json DofJson(const DiveDofSummary& dof) {
  json object = json::object();
  if (dof.has_model) object["model"] = 1;
  if (std::isfinite(dof.heldout_nmae)) object["h"] = ToSevenDigits(dof.heldout_nmae);
  if (std::isfinite(dof.prediction_nmae)) object["p"] = ToSevenDigits(dof.prediction_nmae);
  if (!dof.causes.empty()) object["causes"] = dof.causes;
  if (!dof.verdicts.empty()) object["verdicts"] = dof.verdicts;
  return object;
}

json DiveJson(const DiveSummary& summary) {
  json dofs = json::object();
  for (const auto& [name, dof] : summary.dofs) dofs[name] = DofJson(dof);
  return {{"name", summary.dive},
          {"start", summary.start},
          {"logs", summary.logs},
          {"lost", summary.num_without_model},
          {"red", summary.num_red},
          {"yellow", summary.num_yellow},
          {"dofs", std::move(dofs)}};
}

json LogsJson(const ArchiveReport& report) {
  std::map<std::string, json> pages_of;
  for (const auto& [log_and_dof, path] : report.pages) {
    pages_of[log_and_dof.first][log_and_dof.second] = AddressOf(path);
  }
  json logs = json::array();
  for (const LogRow& log : report.tables.logs) {
    const auto pages = pages_of.find(log.path);
    logs.push_back({log.path,
                    StateText(log.status),
                    log.message,
                    pages == pages_of.end() ? json::object() : pages->second,
                    log.vehicle});
  }
  return logs;
}

json FindingsJson(const Tables& tables) {
  std::map<std::string_view, std::size_t> places;
  for (std::size_t i = 0; i < tables.logs.size(); ++i) places[tables.logs[i].path] = i;
  json findings = json::array();
  for (const FindingRow& row : tables.findings) {
    const auto log = places.find(row.log);
    if (log == places.end()) continue;
    findings.push_back({log->second, row.dof, row.severity, row.text});
  }
  return findings;
}

}  // namespace

std::string DivesJson(const ArchiveReport& report, const std::vector<DiveSummary>& summaries) {
  json dives = json::array();
  for (const DiveSummary& summary : summaries) dives.push_back(DiveJson(summary));
  const json all = {{"dives", std::move(dives)},
                    {"worst", WorstFirst(summaries)},
                    {"logs", LogsJson(report)},
                    {"findings", FindingsJson(report.tables)}};
  return all.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string AddressOf(const std::string& path) {
  std::string address;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80 &&
        (std::isalnum(byte) || std::string_view("/-._~").find(c) != std::string_view::npos)) {
      address += c;
    } else {
      address += fmt::format("%{:02X}", byte);
    }
  }
  return address;
}

}  // namespace fathom
