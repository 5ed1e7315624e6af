// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/log_text.h"

#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"
#include "fathom/log/correct_velocity.h"
#include "fathom/log/hold_out.h"
#include "fathom/log/log_clocks.h"
#include "fathom/log/log_streams.h"
#include "fathom/log/log_yaml.h"
#include "fathom/log/pose_remarks.h"
#include "fathom/log/single_csv.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// Moves the table's stream into the log, with the table's remark.
void Keep(CsvTable table, std::optional<Stream>* stream, Log* log) {
  const bool is_detections = stream == &log->detections;
  const RemarkKind kind = is_detections ? RemarkKind::kDetections : RemarkKind::kGeneral;
  if (const std::string remark = table.Remark(); !remark.empty()) {
    log->remarks.push_back({kind, remark});
  }
  *stream = std::move(table.stream);
}

// Moves the columns of a prefix out of the log's command.
std::optional<Stream> Parted(std::string_view prefix, Log* log) {
  Stream& command = *log->command;
  Stream parted = {command.time, {}, {}}, rest = {command.time, {}, {}};
  for (std::size_t k = 0; k < command.columns.size(); ++k) {
    Stream& to = command.columns[k].starts_with(prefix) ? parted : rest;
    to.columns.push_back(command.columns[k]);
    to.values.push_back(std::move(command.values[k]));
  }
  command = std::move(rest);
  if (parted.columns.empty()) return std::nullopt;
  log->remarks.push_back(
      {RemarkKind::kSurfaces,
       fmt::format("command.csv: {} acts in models that --dofs makes, in no others.",
                   fmt::join(parted.columns, ", "))});
  return parted;
}

// Moves the angles of fins and the revolutions of shafts out of the log's command, which goes if it
// held nothing else.
void PartSurfaces(Log* log) {
  log->fins = Parted("fin_", log);
  log->shafts = Parted("shaft_", log);
  if (log->command->columns.empty()) log->command.reset();
}

// The table's name and stamps; detections hold a row for each tag of a frame.
CsvTable WithEachStampOnce(const CsvTable& table) {
  CsvTable stamps;
  stamps.name = table.name;
  stamps.stream.time = table.stream.time;
  auto& time = stamps.stream.time;
  time.erase(std::unique(time.begin(), time.end()), time.end());
  return stamps;
}

}  // namespace

Log ParseLog(const LogText& text) {
  Log log = ParseLogYaml(text.log_yaml.name, text.log_yaml.text);
  log.path = text.path;

  std::optional<CsvTable> command;
  if (text.command) command = ParseCommand(text.command->name, text.command->text);
  const auto keep_motion = [&](CsvTable motion, std::optional<Stream>* stream) {
    const CsvTable stamps = WithEachStampOnce(motion);
    RefuseStampsThatAreNotSeconds(command ? *command : stamps, stamps);
    if (command) RefuseDisjointClocks(*command, stamps);
    Keep(std::move(motion), stream, &log);
  };
  if (text.velocity) {
    keep_motion(ParseVelocity(text.velocity->name, text.velocity->text), &log.velocity);
  }
  if (text.pose) keep_motion(ParsePose(text.pose->name, text.pose->text), &log.pose);
  if (text.pose && text.pose_yaml) {
    for (const Remark& remark :
         ParsePoseRemarks(text.pose_yaml->name, text.pose_yaml->text, log.pose->time.size())) {
      log.remarks.push_back({remark.kind, "pose.yaml: " + remark.text});
    }
  }
  if (text.detections) {
    keep_motion(ParseDetections(text.detections->name, text.detections->text), &log.detections);
  }
  if (command) {
    Keep(std::move(*command), &log.command, &log);
    PartSurfaces(&log);
  }
  if (text.is_other_velocity) log.corrections.clear();
  CorrectVelocity(text.log_yaml.name,
                  text.velocity ? text.velocity->name : "",
                  text.corrections,
                  text.corrections_by,
                  &log);
  HoldOut(text.held_out, &log);
  return log;
}

Log ParseSingleCsv(const std::string& name,
                   const std::string& text,
                   Dof dof,
                   const std::vector<TimeInterval>& held_out) {
  CsvSpec spec;
  const bool is_decay = IsSingleCsvDecay(text);
  spec.required = is_decay ? std::vector<std::string>{"v"} : std::vector<std::string>{"tau", "v"};
  CsvTable table = ParseCsvTable(name, text, spec);
  RefuseStampsThatAreNotSeconds(table, table);

  Log log;
  log.path = name;
  log.name = ShownOnOneLine(log.path.stem().string());
  log.dofs = {dof};
  if (const std::string remark = table.Remark(); !remark.empty()) {
    log.remarks.push_back({RemarkKind::kGeneral, remark});
  }
  if (!is_decay) {
    log.command = Stream{.time = table.stream.time,
                         .columns = {std::string(ForceColumn(dof))},
                         .values = {*table.stream.Find("tau")}};
  }
  log.velocity = Stream{.time = table.stream.time,
                        .columns = {std::string(VelocityColumn(dof))},
                        .values = {*table.stream.Find("v")}};
  HoldOut(held_out, &log);
  return log;
}

}  // namespace fathom
