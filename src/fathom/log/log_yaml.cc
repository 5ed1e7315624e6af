// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/log_yaml.h"

#include "fathom/base/files/leaves_its_folder.h"
#include "fathom/base/files/yaml_file.h"
#include "fathom/base/quoted.h"
#include "fathom/base/utc_time.h"

#include <algorithm>

#include <fmt/format.h>

namespace fathom {
namespace {

std::vector<Dof> DofsOf(const YamlMap& file) {
  std::vector<Dof> dofs;
  for (const std::string& name : file.Strings("dof")) {
    const auto dof = DofFromName(name);
    if (!dof) {
      file.Fail("dof",
                fmt::format("is {}, expected one or a list of surge, sway, heave, roll, pitch, "
                            "yaw.",
                            Quoted(name)));
    }
    if (std::find(dofs.begin(), dofs.end(), *dof) != dofs.end()) {
      file.Fail("dof", fmt::format("lists {} twice, expected each once.", Quoted(name)));
    }
    dofs.push_back(*dof);
  }
  return dofs;
}

std::vector<TimeInterval> HeldOutOf(const YamlMap& file) {
  std::vector<TimeInterval> intervals;
  if (!file.Has("held_out")) return intervals;
  for (const auto& pair : file.NumberLists("held_out", 2)) {
    if (!(pair[0] < pair[1])) {
      file.Fail(
          "held_out",
          fmt::format("is [{}, {}], expected [from, to] with from before to.", pair[0], pair[1]));
    }
    intervals.push_back({.from = pair[0], .to = pair[1]});
  }
  return intervals;
}

std::vector<Correction> CorrectionsOf(const YamlMap& file) {
  std::vector<Correction> corrections;
  const auto factors = file.OptionalMap("correct");
  const auto late = file.OptionalMap("late");
  for (const Dof dof : kAllDofs) {
    Correction correction = {std::string(VelocityColumn(dof))};
    const std::string& column = correction.column;
    const bool has_factor = factors && factors->Has(column);
    const bool is_late = late && late->Has(column);
    if (has_factor) correction.factor = factors->Number(column);
    if (correction.factor == 0.0) factors->Fail(column, "is 0, expected a factor that is not 0.");
    if (is_late) correction.late = late->Number(column);
    if (has_factor || is_late) corrections.push_back(std::move(correction));
  }
  return corrections;
}

std::optional<double> StartOf(const YamlMap& file) {
  if (!file.Has("start")) return std::nullopt;
  const std::string text = file.String("start");
  const std::optional<double> start = ParseUtc(text);
  if (!start) {
    file.Fail(
        "start",
        fmt::format("is {}, expected an instant in UTC as 2026-05-03T14:30:00Z.", Quoted(text)));
  }
  return start;
}

std::optional<double> MassOf(const YamlMap& file) {
  if (!file.Has("mass")) return std::nullopt;
  const double mass = file.Number("mass");
  if (!(mass > 0.0)) file.Fail("mass", fmt::format("is {}, expected a number above 0.", mass));
  return mass;
}

std::string ThrusterUnitOf(const YamlMap& file) {
  const std::string unit = file.String("thruster_unit", "");
  if (unit.empty() || unit == "Hz") return "";
  if (unit != "N") {
    file.Fail("thruster_unit", fmt::format("is {}, expected Hz or N.", Quoted(unit)));
  }
  return unit;
}

std::string VideoOf(const YamlMap& file) {
  std::string video = file.String("video", "");
  if (LeavesItsFolder(video)) {
    file.Fail(
        "video",
        fmt::format("is {}, expected the path of a video from this folder on.", Quoted(video)));
  }
  return video;
}

double VideoStartOf(const YamlMap& file) {
  if (!file.Has("video_start")) return 0.0;
  if (!file.Has("video")) {
    file.Fail("video_start", "belongs to a video, expected the key 'video' beside it.");
  }
  return file.Number("video_start");
}

std::optional<LogOrigin> OriginOf(const YamlMap& file) {
  const auto origin = file.OptionalMap("imported");
  if (!origin) return std::nullopt;
  LogOrigin result;
  result.file = origin->String("file");
  result.content = origin->String("content", "");
  result.map = origin->String("map", "");
  result.row_counter = origin->String("row_counter", "");
  if (const auto shares = origin->OptionalMap("out_of_order")) {
    for (const std::string& stream : shares->Keys()) {
      result.out_of_order.push_back({stream, shares->Number(stream)});
    }
  }
  if (LeavesItsFolder(result.map)) {
    origin->Fail("map", fmt::format("is {}, expected a file in this folder.", Quoted(result.map)));
  }
  return result;
}

}  // namespace

Log ParseLogYaml(const std::string& name, const std::string& text) {
  const YamlMap file = ParseYaml(name, text);
  Log log;
  log.name = file.Name("name");
  log.dofs = DofsOf(file);
  log.vehicle = file.String("vehicle", "");
  log.notes = file.String("notes", "");
  log.dive = file.String("dive", "");
  log.start = StartOf(file);
  log.held_out = HeldOutOf(file);
  log.corrections = CorrectionsOf(file);
  log.mass = MassOf(file);
  log.command_unit = file.String("command_unit", "");
  log.thruster_unit = ThrusterUnitOf(file);
  log.video = VideoOf(file);
  log.video_start = VideoStartOf(file);
  log.origin = OriginOf(file);
  file.Finish();
  return log;
}

}  // namespace fathom
