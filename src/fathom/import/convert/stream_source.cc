// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/convert/stream_source.h"

#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"
#include "fathom/import/recording/find_channel.h"
#include "fathom/import/table/table_stamps.h"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

namespace fathom {
namespace {

// The channel that a map means: the only one, one of this name, or the first instance of a type of
// this name ("XKF1" of "XKF1[0]", "XKF1[1]").
const Channel& ChannelOf(const std::filesystem::path& file,
                         const Contents& contents,
                         const std::string& column,
                         const std::string& name,
                         std::vector<std::string>* remarks) {
  if (name.empty() && contents.channels.size() == 1) return contents.channels.front();
  if (name.empty()) {
    throw InputError(
        fmt::format("{}: has {} channels, expected the map to name that of {} with "
                    "'channel'.",
                    file.string(),
                    contents.channels.size(),
                    Quoted(column)));
  }
  const auto& channels = contents.channels;
  const bool is_there = std::any_of(
      channels.begin(), channels.end(), [&](const Channel& c) { return c.name == name; });
  if (!is_there) {
    for (const Channel& channel : channels) {
      if (channel.type != name || channel.name.find('[') == std::string::npos) continue;
      std::string remark = fmt::format("{} has several instances: {} is read.", name, channel.name);
      if (std::find(remarks->begin(), remarks->end(), remark) == remarks->end()) {
        remarks->push_back(std::move(remark));
      }
      return channel;
    }
  }
  return FindChannel(contents, file, {name, {}});
}

// By its name, by the text of a header with its unit, or by its number.
const Field& FieldOf(const std::filesystem::path& file,
                     const Contents& contents,
                     const Channel& channel,
                     const std::string& name) {
  const int index = FindColumn(channel.fields, name);
  if (index >= 0) return channel.fields[index];
  FindChannel(contents, file, {channel.name, {name}});  // throws
  return channel.fields.front();
}

// Adds further fields to a sum. All state the same unit, or the map says it.
void AddFields(const std::filesystem::path& file,
               const Contents& contents,
               const Channel& channel,
               const ColumnMap& map,
               const Field& first,
               Selection* selection) {
  for (const std::string& name : map.added) {
    const Field& field = FieldOf(file, contents, channel, name);
    if (map.unit.empty() && field.unit != first.unit) {
      throw InputError(fmt::format(
          "{}: {} {} is in {}, expected the unit of {}, to which it is added: {}. Say the unit of "
          "both in the map with 'unit'.",
          file.string(),
          channel.name,
          Quoted(field.name),
          Quoted(field.unit),
          Quoted(first.name),
          Quoted(first.unit)));
    }
    selection->fields.push_back(field.name);
  }
}

}  // namespace

double ColumnSource::InSi(double number) const {
  constexpr double kTwiceTheMiddle = 3000.0;  // of pulses [us]
  const double value = (number * scale + offset) * unit.factor;
  if (!is_reversed || value == 0.0) return value;
  return unit.dimension == Dimension::kPulse ? kTwiceTheMiddle - value : -value;
}

std::optional<Dimension> DimensionOf(std::string_view column) {
  if (column.starts_with("thruster_")) return std::nullopt;
  if (column.starts_with("fin_")) return Dimension::kAngle;
  if (column.starts_with("shaft_")) return Dimension::kRotation;
  if (column == "voltage") return Dimension::kVoltage;
  if (column == "time") return Dimension::kTime;
  if (column == "tau_surge" || column == "tau_sway" || column == "tau_heave") {
    return Dimension::kForce;
  }
  if (column.starts_with("tau_")) return Dimension::kMoment;
  if (column == "u" || column == "v" || column == "w") return Dimension::kSpeed;
  if (column == "p" || column == "q" || column == "r") return Dimension::kAngularRate;
  if (column == "x" || column == "y" || column == "z") return Dimension::kLength;
  if (column == "roll" || column == "pitch" || column == "yaw") return Dimension::kAngle;
  return Dimension::kPlain;
}

ColumnSource SourceOf(const std::filesystem::path& file,
                      const Contents& contents,
                      const StreamMap& stream,
                      const std::string& column,
                      const ColumnMap& map,
                      bool is_plain,
                      std::vector<std::string>* remarks) {
  const std::string& channel_name = map.channel.empty() ? stream.channel : map.channel;
  const Channel& channel = ChannelOf(file, contents, column, channel_name, remarks);
  const Field& field = FieldOf(file, contents, channel, map.field);
  ColumnSource source = {
      column, {channel.name, {field.name}}, {}, map.scale, map.offset, map.is_reversed};
  AddFields(file, contents, channel, map, field, &source.selection);
  const auto dimension = DimensionOf(column);
  if (map.pulses) source.is_reversed = false;  // AnglesOfPulses() turns the angle
  if (is_plain || dimension == Dimension::kPlain) return source;

  // The stream's unit is that of the columns that it fits: cm/s not of a yaw rate.
  const bool is_of_stream = map.unit.empty() && !stream.unit.empty() &&
                            (!dimension || FindUnit(stream.unit, *dimension).has_value());
  const std::string& text = is_of_stream ? stream.unit : map.unit.empty() ? field.unit : map.unit;
  const std::string place =
      fmt::format("{}: {} {}", file.string(), channel.name, Quoted(field.name));
  if (text.empty()) {
    if (!dimension) {
      throw InputError(
          fmt::format("{} states no unit, expected the map to give that of {}: 'Hz', "
                      "'rpm', 'us', '%' or 'N'.",
                      place,
                      Quoted(column)));
    }
    source.unit = {*dimension, 1.0};
    source.is_unit_open = dimension == Dimension::kTime;
    if (source.is_unit_open) return source;
    remarks->push_back(fmt::format("{} {} states no unit: taken as {}.",
                                   channel.name,
                                   Quoted(field.name),
                                   SiUnit(*dimension)));
    return source;
  }
  std::optional<Unit> unit;
  if (dimension) {
    unit = FindUnit(text, *dimension);
  } else {
    for (const Dimension q :
         {Dimension::kPulse, Dimension::kShare, Dimension::kRotation, Dimension::kForce}) {
      if (!unit) unit = FindUnit(text, q);
    }
  }
  if (!unit) {
    throw InputError(fmt::format(
        "{} is in {}, expected {} for {}: {}. Say its unit in the map with 'unit'{}.",
        place,
        Quoted(text),
        dimension ? Name(*dimension) : "a pulse width, a share, a speed or a force",
        Quoted(column),
        dimension ? UnitsOf(*dimension) : "'us', '%', 'Hz', 'rpm', 'N'",
        dimension == Dimension::kTime ? fmt::format(": 'time: {{field: {}, unit: ms}}'", field.name)
        : column.starts_with("tau_")
            ? fmt::format("; a command that is none of these is taken as it is with "
                          "'command_unit: \"{}\"'",
                          text)
            : ""));
  }
  source.unit = *unit;
  return source;
}

}  // namespace fathom
