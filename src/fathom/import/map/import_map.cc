// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/map/import_map.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/files/yaml_file.h"
#include "fathom/base/quoted.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::array<std::string_view, 6> kVelocity = {"u", "v", "w", "p", "q", "r"};
constexpr std::array<std::string_view, 10> kPose = {
    "x", "y", "z", "qx", "qy", "qz", "qw", "roll", "pitch", "yaw"};
constexpr std::array<std::pair<std::string_view, Frame>, 5> kFrames = {{{"FRD", Frame::kFrd},
                                                                        {"FLU", Frame::kFlu},
                                                                        {"NED", Frame::kNed},
                                                                        {"ENU", Frame::kEnu},
                                                                        {"NWU", Frame::kNwu}}};

std::optional<Frame> FrameOf(const YamlMap& map, bool is_world_only, bool is_body_only) {
  if (!map.Has("frame")) return std::nullopt;
  const std::string text = map.String("frame");
  for (const auto& [name, frame] : kFrames) {
    const bool is_body = frame == Frame::kFrd || frame == Frame::kFlu;
    if (text == name && !(is_world_only && is_body) && !(is_body_only && !is_body)) return frame;
  }
  map.Fail("frame",
           fmt::format("is {}, expected {}.",
                       Quoted(text),
                       is_world_only  ? "NED, ENU or NWU"
                       : is_body_only ? "FRD or FLU"
                                      : "FRD, FLU, NED, ENU or NWU"));
}

std::vector<Condition> ConditionsOf(const YamlMap& map) {
  std::vector<Condition> conditions;
  if (const auto where = map.OptionalMap("where")) {
    for (const std::string& key : where->Keys()) conditions.push_back({key, where->Number(key)});
  }
  return conditions;
}

// `u: VN`, or `u: {field: VN, unit: cm/s, scale: -1, offset: 0, channel: XKF1}`.
//
// Or of several fields of a channel, in one unit: `u: {sum: [left, right], unit: N}`. A thruster's
// may also be `reversed`.
ColumnMap ColumnOf(const YamlMap& map, std::string_view key, bool is_thruster = false) {
  ColumnMap column;
  if (!map.HoldsMap(key)) {
    column.field = map.String(key);
    return column;
  }
  const YamlMap entry = map.Map(key);
  if (entry.Has("sum")) {
    if (entry.Has("field")) entry.Fail("sum", "stands beside 'field', expected one of the two.");
    column.added = entry.Strings("sum");
    if (column.added.size() < 2) entry.Fail("sum", "expected a list of two fields at least.");
    column.field = column.added.front();
    column.added.erase(column.added.begin());
  } else {
    column.field = entry.String("field");
  }
  column.channel = entry.String("channel", "");
  column.unit = entry.String("unit", "");
  column.scale = entry.Number("scale", 1.0);
  column.offset = entry.Number("offset", 0.0);
  if (is_thruster) column.is_reversed = entry.Boolean("reversed", false);
  if (column.scale == 0.0) entry.Fail("scale", "is 0, expected another number.");
  return column;
}

// `time: sent`, `{field: sent, unit: ns}`, or `{seconds: secs, nanoseconds: nsecs}`.
void ReadTime(const YamlMap& map, StreamMap* stream) {
  if (!map.HoldsMap("time") || !map.Map("time").Has("seconds")) {
    stream->time = ColumnOf(map, "time");
    return;
  }
  const YamlMap time = map.Map("time");
  stream->time.emplace();
  stream->time->field = time.String("seconds");
  stream->time->unit = "s";
  stream->time->channel = time.String("channel", "");
  stream->nanoseconds = time.String("nanoseconds");
}

// What all streams have; the caller adds the columns.
StreamMap StreamOf(const YamlMap& map) {
  StreamMap stream;
  stream.channel = map.String("channel", "");
  stream.unit = map.String("unit", "");
  if (map.Has("rate")) {
    stream.rate = map.Number("rate");
    if (!(*stream.rate > 0.0)) {
      map.Fail("rate", fmt::format("is {}, expected a rate above 0 Hz.", *stream.rate));
    }
  }
  stream.delay = map.Number("delay", 0.0);
  if (map.Has("time")) ReadTime(map, &stream);
  stream.where = ConditionsOf(map);
  return stream;
}

template <typename Names>
void AddColumns(const YamlMap& map, const Names& names, StreamMap* stream) {
  for (const auto& name : names) {
    if (map.Has(name)) stream->columns.emplace_back(name, ColumnOf(map, name));
  }
}

// thruster_1, thruster_2, ...: none is left out.
std::vector<std::string> ThrusterColumns(const YamlMap& map) {
  std::vector<std::string> names;
  while (map.Has(fmt::format("thruster_{}", names.size() + 1))) {
    names.push_back(fmt::format("thruster_{}", names.size() + 1));
  }
  return names;
}

// fin_rudder, shaft_port, ...: their names stand in the head of command.csv.
std::vector<std::string> NamedColumns(const YamlMap& map, const std::string& prefix) {
  std::vector<std::string> names;
  for (const std::string& key : map.Keys()) {
    if (!key.starts_with(prefix)) continue;
    const bool is_name =
        key.size() > prefix.size() && std::all_of(key.begin(), key.end(), [](char c) {
          return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
        });
    if (!is_name) {
      map.Fail(key, fmt::format("expected {}<name> in letters, digits and '_'.", prefix));
    }
    names.push_back(key);
  }
  return names;
}

// As any column, or of the pulses of its servo.
ColumnMap FinColumnOf(const YamlMap& map, const std::string& key) {
  ColumnMap column = ColumnOf(map, key);
  if (!map.HoldsMap(key)) return column;
  const YamlMap entry = map.Map(key);
  if (!entry.Has("pulses")) return column;
  if (!column.unit.empty()) entry.Fail("unit", "stands beside 'pulses', which are in us.");
  const std::vector<double> pulses = entry.Numbers("pulses", 3);
  if (!(pulses[0] < pulses[1] && pulses[1] < pulses[2])) {
    entry.Fail("pulses", "do not increase, expected the least, that at rest and the largest [us].");
  }
  column.pulses = {pulses[0], pulses[1], pulses[2]};
  column.is_reversed = entry.Boolean("reversed", false);
  if (entry.Has("largest_angle")) {
    column.largest_angle = entry.Number("largest_angle");
    if (!(*column.largest_angle > 0.0 && *column.largest_angle < 1.6)) {
      entry.Fail(
          "largest_angle",
          fmt::format("is {}, expected an angle above 0 and below a right angle, in radians.",
                      *column.largest_angle));
    }
  }
  return column;
}

void ReadCommand(const YamlMap& map, ImportMap* result) {
  StreamMap stream = StreamOf(map);
  stream.frame = FrameOf(map, /*is_world_only=*/false, /*is_body_only=*/true);
  std::vector<std::string> names;
  for (const Dof dof : kAllDofs) names.emplace_back(ForceColumn(dof));
  AddColumns(map, names, &stream);
  const std::vector<std::string> thrusters = ThrusterColumns(map);
  if (!thrusters.empty() && !stream.columns.empty()) {
    map.Fail("thruster_1", "stands beside a force, expected forces or thrusters.");
  }
  for (const std::string& name : thrusters) {
    stream.columns.emplace_back(name, ColumnOf(map, name, /*is_thruster=*/true));
  }
  for (const std::string& name : NamedColumns(map, "fin_")) {
    stream.columns.emplace_back(name, FinColumnOf(map, name));
  }
  AddColumns(map, NamedColumns(map, "shaft_"), &stream);
  if (stream.columns.empty()) {
    map.Fail(
        "names no column, expected some of tau_surge ... tau_yaw, or thruster_1 and on, or "
        "fin_<name>, or shaft_<name>.");
  }
  if (map.Has("voltage")) {
    if (!map.HoldsMap("voltage")) {
      result->fixed_voltage = map.Number("voltage");
      if (!(*result->fixed_voltage > 0.0)) map.Fail("voltage", "is not above 0 V.");
    } else {
      result->voltage = ColumnOf(map, "voltage");
    }
  }
  result->command = std::move(stream);
}

StreamMap VelocityOf(const YamlMap& map) {
  StreamMap stream = StreamOf(map);
  stream.frame = FrameOf(map, /*is_world_only=*/false, /*is_body_only=*/false);
  AddColumns(map, kVelocity, &stream);
  if (stream.columns.empty()) map.Fail("names no column, expected some of u, v, w, p, q, r.");
  return stream;
}

StreamMap PoseOf(const YamlMap& map) {
  StreamMap stream = StreamOf(map);
  stream.frame = FrameOf(map, /*is_world_only=*/true, /*is_body_only=*/false);
  AddColumns(map, kPose, &stream);
  const auto has = [&](std::string_view name) { return stream.Find(name) != nullptr; };
  const bool has_angle = has("roll") || has("pitch") || has("yaw");
  const int num_quaternion = has("qx") + has("qy") + has("qz") + has("qw");
  if (has("x") != has("y")) map.Fail("names one of x and y, expected both or none.");
  if (num_quaternion % 4 != 0) map.Fail("names a part of a quaternion, expected qx qy qz qw.");
  if (num_quaternion == 4 && has_angle) {
    map.Fail("names a quaternion and angles, expected qx qy qz qw, or some of roll, pitch, yaw.");
  }
  const bool has_attitude = num_quaternion == 4 || has_angle;
  if (has("x") && !has_attitude) {
    map.Fail("names no attitude, expected an attitude: qx qy qz qw, or some of roll, pitch, yaw.");
  }
  if (!has_attitude && !has("z")) {
    map.Fail("names no column, expected a position, an attitude or both, or z alone.");
  }
  return stream;
}

char SeparatorOf(const YamlMap& map) {
  const std::string text = map.String("separator");
  if (text == "tab" || text == "\t") return '\t';
  if (text == "blank" || text == " ") return kBlanks;
  if (text.size() == 1 && std::string_view(",;|").find(text.front()) != std::string_view::npos) {
    return text.front();
  }
  map.Fail("separator",
           fmt::format("is {}, expected \",\", \";\", \"|\", tab or blank.", Quoted(text)));
}

TableOptions TableOf(const YamlMap& map) {
  TableOptions options;
  if (map.Has("separator")) options.separator = SeparatorOf(map);
  if (map.Has("decimal")) {
    const std::string text = map.String("decimal");
    if (text != "." && text != ",") {
      map.Fail("decimal", fmt::format("is {}, expected \".\" or \",\".", Quoted(text)));
    }
    options.decimal = text.front();
  }
  if (map.Has("header_line")) {
    const auto line = map.Integer("header_line");
    if (line < 0 || line > 1000) {
      map.Fail("header_line", fmt::format("is {}, expected 0 to 1000.", line));
    }
    options.header_line = static_cast<int>(line);
  }
  options.time = map.String("time", "");
  options.time_unit = map.String("time_unit", "");
  return options;
}

std::vector<Dof> DofsOf(const YamlMap& file) {
  std::vector<Dof> dofs;
  if (!file.Has("dof")) return dofs;
  for (const std::string& name : file.Strings("dof")) {
    const auto dof = DofFromName(name);
    if (!dof || std::find(dofs.begin(), dofs.end(), *dof) != dofs.end()) {
      file.Fail("dof",
                fmt::format("holds {}, expected each of surge, sway, heave, roll, pitch, yaw at "
                            "most once.",
                            Quoted(name)));
    }
    dofs.push_back(*dof);
  }
  return dofs;
}

std::vector<TimeInterval> HeldOutOf(const YamlMap& file) {
  std::vector<TimeInterval> intervals;
  if (!file.Has("held_out")) return intervals;
  for (const auto& pair : file.NumberLists("held_out", 2)) {
    if (!(pair[0] < pair[1])) file.Fail("held_out", "expected [from, to] with from before to.");
    intervals.push_back({pair[0], pair[1]});
  }
  return intervals;
}

}  // namespace

const ColumnMap* StreamMap::Find(std::string_view column) const {
  for (const auto& [name, map] : columns) {
    if (name == column) return &map;
  }
  return nullptr;
}

ImportMap ReadImportMap(const std::filesystem::path& path) {
  return ParseImportMap(path.string(), ReadFile(path));
}

ImportMap ParseImportMap(const std::string& name, const std::string& text) {
  const YamlMap file = ParseYaml(name, text);
  ImportMap map;
  file.Ignore("when");  // read by whoever chooses among maps
  if (file.Has("name")) map.name = file.Name("name");
  map.dofs = DofsOf(file);
  map.vehicle = file.String("vehicle", "");
  if (file.Has("mass")) {
    map.mass = file.Number("mass");
    if (!(*map.mass > 0.0)) file.Fail("mass", fmt::format("is {}, expected above 0.", *map.mass));
  }
  map.dive = file.String("dive", "");
  map.notes = file.String("notes", "");
  map.held_out = HeldOutOf(file);
  map.command_unit = file.String("command_unit", "");
  if (const auto table = file.OptionalMap("table")) map.table = TableOf(*table);
  if (const auto command = file.OptionalMap("command")) ReadCommand(*command, &map);
  if (const auto velocity = file.OptionalMap("velocity")) map.velocity = VelocityOf(*velocity);
  if (const auto pose = file.OptionalMap("pose")) map.pose = PoseOf(*pose);
  if (const auto camera = file.OptionalMap("camera")) map.camera = CameraMapOf(*camera);
  file.Finish();
  if (!map.command && !map.velocity && !map.pose) {
    file.Fail("names no stream, expected some of command, velocity, pose.");
  }
  return map;
}

std::vector<std::filesystem::path> FilesNamedBy(const std::filesystem::path& map_file) {
  const ImportMap map = ReadImportMap(map_file);
  std::vector<std::filesystem::path> files;
  if (!map.vehicle.empty()) files.push_back(map_file.parent_path() / map.vehicle);
  if (map.camera) {
    for (const auto& [in_log, file] : map.camera->Files()) {
      files.push_back(map_file.parent_path() / file);
    }
  }
  return files;
}

}  // namespace fathom
