// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/write_log.h"

#include "fathom/base/files/output_file.h"
#include "fathom/base/input_error.h"
#include "fathom/base/utc_time.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <system_error>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

namespace fathom {
namespace {

void WriteOrRequireNone(const std::filesystem::path& path, const std::optional<Stream>& stream) {
  if (stream) {
    WriteStream(path, *stream);
    return;
  }
  std::error_code error;
  if (std::filesystem::exists(path, error)) {
    throw InputError(
        path.string() +
        ": is left from another log, and the log to be written has no such stream. Remove "
        "it, or write into an empty folder.");
  }
}

// Thrusts or forces, and beside them the angles of fins and the revolutions of shafts.
std::optional<Stream> CommandFile(const Log& log) {
  std::optional<Stream> command = log.thrusters ? log.thrusters : log.command;
  for (const std::optional<Stream>* beside : {&log.fins, &log.shafts}) {
    if (!*beside) continue;
    if (!command) {
      command = *beside;
      continue;
    }
    for (std::size_t k = 0; k < (*beside)->columns.size(); ++k) {
      command->columns.push_back((*beside)->columns[k]);
      command->values.push_back((*beside)->values[k]);
    }
  }
  return command;
}

std::string FormatYaml(const Log& log, const std::vector<Correction>& corrections) {
  YAML::Emitter yaml;
  const auto emit_text = [&](const char* key, const std::string& text) {
    if (!text.empty()) yaml << YAML::Key << key << YAML::Value << YAML::DoubleQuoted << text;
  };
  yaml << YAML::BeginMap;
  yaml << YAML::Key << "name" << YAML::Value << YAML::DoubleQuoted << log.name;
  yaml << YAML::Key << "dof" << YAML::Value << YAML::Flow << YAML::BeginSeq;
  for (const Dof dof : log.dofs) yaml << std::string(Name(dof));
  yaml << YAML::EndSeq;
  emit_text("vehicle", log.vehicle);
  if (log.mass) yaml << YAML::Key << "mass" << YAML::Value << fmt::format("{}", *log.mass);
  emit_text("dive", log.dive);
  if (log.start) emit_text("start", FormatUtc(*log.start));
  if (!log.held_out.empty()) {
    yaml << YAML::Key << "held_out" << YAML::Value << YAML::Flow << YAML::BeginSeq;
    for (const TimeInterval& interval : log.held_out) {
      yaml << YAML::Flow << YAML::BeginSeq << fmt::format("{}", interval.from)
           << fmt::format("{}", interval.to) << YAML::EndSeq;
    }
    yaml << YAML::EndSeq;
  }
  const auto emit_corrections = [&](const char* key, double Correction::*number, double none) {
    const auto is_one = [&](const Correction& correction) { return correction.*number != none; };
    if (!std::ranges::any_of(corrections, is_one)) return;
    yaml << YAML::Key << key << YAML::Value << YAML::Flow << YAML::BeginMap;
    for (const Correction& correction : corrections) {
      if (!is_one(correction)) continue;
      yaml << YAML::Key << correction.column << YAML::Value
           << fmt::format("{}", correction.*number);
    }
    yaml << YAML::EndMap;
  };
  emit_corrections("correct", &Correction::factor, 1.0);
  emit_corrections("late", &Correction::late, 0.0);
  emit_text("command_unit", log.command_unit);
  emit_text("thruster_unit", log.thrusters ? "N" : log.thruster_unit);
  emit_text("video", log.video);
  if (!log.video.empty() && log.video_start != 0.0) {
    yaml << YAML::Key << "video_start" << YAML::Value << fmt::format("{}", log.video_start);
  }
  emit_text("notes", log.notes);
  if (log.origin) {
    yaml << YAML::Key << "imported" << YAML::Value << YAML::BeginMap;
    emit_text("file", log.origin->file);
    emit_text("content", log.origin->content);
    emit_text("map", log.origin->map);
    emit_text("row_counter", log.origin->row_counter);
    if (!log.origin->out_of_order.empty()) {
      yaml << YAML::Key << "out_of_order" << YAML::Value << YAML::Flow << YAML::BeginMap;
      for (const StampsOutOfOrder& stamps : log.origin->out_of_order) {
        yaml << YAML::Key << stamps.stream << YAML::Value << fmt::format("{:.3g}", stamps.share);
      }
      yaml << YAML::EndMap;
    }
    yaml << YAML::EndMap;
  }
  yaml << YAML::EndMap;
  return std::string(yaml.c_str()) + "\n";
}

}  // namespace

std::string FormatLogYaml(const Log& log) { return FormatYaml(log, log.corrections); }

void WriteStream(const std::filesystem::path& path, const Stream& stream) {
  std::string csv = "t";
  for (const std::string& column : stream.columns) csv += "," + column;
  csv += "\n";
  for (std::size_t row = 0; row < stream.time.size(); ++row) {
    fmt::format_to(std::back_inserter(csv), "{}", stream.time[row]);
    for (const auto& column : stream.values) {
      fmt::format_to(std::back_inserter(csv), ",{}", column[row]);
    }
    csv += "\n";
  }
  WriteFile(path, csv);
}

void WriteLog(const std::filesystem::path& folder, const Log& log) {
  WriteOrRequireNone(folder / "command.csv", CommandFile(log));
  WriteOrRequireNone(folder / "velocity.csv", log.velocity);
  WriteOrRequireNone(folder / "pose.csv", log.pose);
  WriteOrRequireNone(folder / "detections.csv", log.detections);
  // On the poses of another log.
  WriteOrRequireNone(folder / "pose.yaml", std::nullopt);
  // Its velocities are corrected already.
  WriteFile(folder / "log.yaml", FormatYaml(log, {}));
}

}  // namespace fathom
