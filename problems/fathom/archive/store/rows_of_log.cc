// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/store/rows_of_log.h"

#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using Json = nlohmann::ordered_json;

Json ParseObject(const std::string& text) {
  Json json = Json::parse(text, nullptr, false);
  return json.is_object() ? json : Json::object();
}

// What stands under a key, or something empty of the type that is asked for.
double Number(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_number() ? found->get<double>() : kNoNumber;
}

std::string Text(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>() : "";
}

bool Flag(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_boolean() && found->get<bool>();
}

const Json& Part(const Json& json, const char* key) {
  static const Json kNothing = Json::object();
  const auto found = json.find(key);
  return found != json.end() ? *found : kNothing;
}

// A row for each of `parameters`, like `row` in all else.
template <typename Row>
void AddParameters(const Json& parameters, Row row, std::vector<Row>* rows) {
  for (const auto& [name, parameter] : parameters.items()) {
    row.parameter = name;
    row.value = Number(parameter, "value");
    row.std = Number(parameter, "std");
    row.unit = Text(parameter, "unit");
    rows->push_back(row);
  }
}

void AddComparison(const std::string& log, const Json& json, Tables* tables) {
  for (const Json& row : Part(json, "rows")) {
    FitRow fit = {.log = log,
                  .dof = Text(row, "dof"),
                  .family = Text(row, "family"),
                  .source = Text(row, "source"),
                  .usable = Flag(row, "usable"),
                  .parameter = "",
                  .unit = "",
                  .message = Text(row, "message")};
    AddParameters(Part(row, "parameters"), fit, &tables->fits);
    tables->scores.push_back({.log = log,
                              .dof = fit.dof,
                              .family = fit.family,
                              .source = fit.source,
                              .mae = Number(row, "mae"),
                              .nmae = Number(row, "nmae"),
                              .heldout_mae = Number(row, "heldout_mae"),
                              .heldout_nmae = Number(row, "heldout_nmae")});
  }
  for (const Json& finding : Part(json, "findings")) {
    tables->findings.push_back({.log = log,
                                .dof = Text(finding, "dof"),
                                .severity = Text(finding, "severity"),
                                .id = Text(finding, "code"),
                                .text = Text(finding, "sentence")});
  }
}

// "velocity_coupling(sway)" of an effect with a partner.
std::string LabelOf(const Json& cause) {
  const std::string partner = Text(cause, "partner");
  return partner.empty() ? Text(cause, "effect")
                         : fmt::format("{}({})", Text(cause, "effect"), partner);
}

void AddVerdict(const std::string& log,
                const std::string& verdict_file,
                const Json& json,
                Tables* tables) {
  const std::string dof = Text(json, "dof");
  tables->verdicts.push_back({.log = log,
                              .dof = dof,
                              .verdict = Text(json, "verdict"),
                              .sentence = Text(json, "sentence"),
                              .json = verdict_file});
  for (const Json& cause : Part(json, "causes")) {
    CauseRow row = {.log = log,
                    .dof = dof,
                    .effect = LabelOf(cause),
                    .parameter = "",
                    .unit = "",
                    .p_value = Number(cause, "p_value"),
                    .heldout_gain = Number(cause, "heldout_gain")};
    const Json& parameters = Part(cause, "parameters");
    AddParameters(parameters, row, &tables->causes);
    if (parameters.empty()) tables->causes.push_back(row);
  }
}

// The name of the rung that stands.
std::string AcceptedStructure(const Json& verdict) {
  for (const Json& rung : Part(verdict, "ladder")) {
    if (Flag(rung, "accepted")) return Text(rung, "structure");
  }
  return "";
}

// A coupled model: its structure stands in the column of the source, the DOFs together in theirs.
// Its findings are those of the single DOFs, which their programs told.
void AddCoupled(const std::string& log, const CoupledRun& run, Tables* tables) {
  for (const UndrivenDof& dof : run.left_out) {
    tables->findings.push_back({.log = log,
                                .dof = std::string(Name(dof.dof)),
                                .severity = "yellow",
                                .id = std::string(kLeftOutOfCoupled),
                                .text = dof.why});
  }
  const Json json = IsUsable(run.diagnose) ? ParseObject(run.diagnose.output) : Json::object();
  FitRow fit = {.log = log,
                .dof = run.dofs,
                .family = std::string(kCoupledFamily),
                .source = AcceptedStructure(json),
                .usable = !json.empty(),
                .parameter = "",
                .unit = "",
                .message = ""};
  if (!fit.usable) {
    fit.message = IsUsable(run.diagnose) ? "its verdict file is damaged." : WhyNot(run.diagnose);
    tables->fits.push_back(fit);
    return;
  }
  AddParameters(Part(Part(json, "model"), "parameters"), fit, &tables->fits);
  tables->verdicts.push_back({.log = log,
                              .dof = run.dofs,
                              .verdict = Text(json, "verdict"),
                              .sentence = Text(json, "sentence"),
                              .json = run.diagnose.output});
  for (const Json& cause : Part(json, "causes")) {
    tables->causes.push_back({.log = log,
                              .dof = run.dofs,
                              .effect = Text(cause, "entry"),
                              .parameter = Text(cause, "entry"),
                              .value = Number(cause, "value"),
                              .std = Number(cause, "std"),
                              .unit = Text(cause, "unit")});
  }
}

std::string LeftOutText(const std::vector<LeftOutLog>& logs) {
  std::vector<std::string> texts;
  for (const LeftOutLog& log : logs) texts.push_back(fmt::format("{} ({})", log.path, log.why));
  return texts.empty() ? "" : fmt::format("Left out: {}.", fmt::join(texts, ", "));
}

// A row for each number of a model file, like `row` in all else.
std::vector<DiveFitRow> RowsOfModel(const std::string& model, const DiveFitRow& row) {
  std::vector<DiveFitRow> rows;
  const Json json = ParseObject(model);
  AddParameters(Part(json, "parameters"), row, &rows);
  return rows;
}

std::string Joined(const std::string& a, const std::string& b) {
  return a.empty() || b.empty() ? a + b : a + " " + b;
}

}  // namespace

Tables RowsOfLog(const LogOutcome& outcome) {
  Tables tables;
  for (const DofRuns& runs : outcome.dofs) {
    AddComparison(outcome.path, ParseObject(runs.compare.output), &tables);
    if (!runs.diagnose || !IsUsable(*runs.diagnose)) continue;
    const Json verdict = ParseObject(runs.diagnose->output);
    if (!verdict.empty()) AddVerdict(outcome.path, runs.diagnose->output, verdict, &tables);
  }
  if (outcome.coupled) AddCoupled(outcome.path, *outcome.coupled, &tables);
  return tables;
}

std::vector<DiveFitRow> RowsOfDive(const DiveTask& task,
                                   const DiveOutcome& outcome,
                                   const std::vector<LeftOutLog>& excluded) {
  std::vector<LeftOutLog> left_out = excluded;
  left_out.insert(left_out.end(), outcome.left_out.begin(), outcome.left_out.end());
  DiveFitRow row = {.dive = task.dive,
                    .dof = std::string(Name(task.dof)),
                    .usable = outcome.identify && IsUsable(*outcome.identify),
                    .parameter = "",
                    .unit = "",
                    .logs = static_cast<int>(outcome.logs.size()),
                    .message = LeftOutText(left_out),
                    .vehicle = task.vehicle};
  if (!row.usable) {
    const std::string why = outcome.identify ? WhyNot(*outcome.identify) : "no log can be fitted.";
    row.message = Joined(why, row.message);
    return {row};
  }
  return RowsOfModel(outcome.identify->output, row);
}

std::vector<DiveFitRow> RowsOfCoupledDive(const CoupledDiveTask& task, const RunRecord& run) {
  DiveFitRow row = {.dive = task.dive,
                    .dof = task.dofs,
                    .usable = IsUsable(run),
                    .parameter = "",
                    .unit = "",
                    .logs = static_cast<int>(task.logs.size()),
                    .message = "",
                    .vehicle = task.vehicle};
  if (row.usable) return RowsOfModel(run.output, row);
  row.message = WhyNot(run);
  return {row};
}

}  // namespace fathom
