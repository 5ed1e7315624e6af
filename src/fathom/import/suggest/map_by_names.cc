// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/suggest/map_by_names.h"

#include "fathom/base/files/yaml_file.h"
#include "fathom/base/number.h"
#include "fathom/base/quoted.h"
#include "fathom/import/convert/stream_source.h"
#include "fathom/import/recording/data_files.h"
#include "fathom/import/suggest/named_channels.h"
#include "fathom/import/units/unit.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

// Two forces side by side: no columns of a log, but together that of surge.
constexpr const char* kPort = "force_port";
constexpr const char* kStarboard = "force_starboard";

// What people call a column, letters and digits only, in lower case; the surest first.
struct ColumnNames {
  std::string column;
  std::vector<std::string> names;
};

// Of one stream, from data/import/column_names.yaml.
std::vector<ColumnNames> NamesOfStream(std::string_view stream) {
  static const YamlMap kFile =
      ParseYaml("column_names.yaml", std::string(data_files::column_names));
  const YamlMap of_stream = kFile.Map(stream);
  std::vector<ColumnNames> all;
  for (const std::string& column : of_stream.Keys()) {
    all.push_back({column, of_stream.Strings(column)});
  }
  return all;
}

std::string LettersOf(std::string_view text) {
  std::string letters;
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return letters;
}

// A field that was found for a column.
struct Found {
  std::string column;
  Field field;
  FieldPlace place;
  std::string added = {};  // a second field, whose numbers are added to it; may be empty
};

// At most one column for each field. A field in a unit of another dimension is not it.
std::vector<Found> FindByNames(const std::vector<ColumnNames>& table,
                               const NamedChannel& named,
                               std::vector<std::string>* taken) {
  const Channel& channel = named.channel;
  std::vector<Found> all;
  for (const ColumnNames& entry : table) {
    const Dimension dimension = DimensionOf(entry.column).value_or(Dimension::kForce);
    std::optional<std::size_t> best;
    for (const std::string& name : entry.names) {
      for (std::size_t i = 0; i < channel.fields.size(); ++i) {
        const Field& field = channel.fields[i];
        const bool is_free = std::find(taken->begin(), taken->end(), field.name) == taken->end();
        const bool fits = field.unit.empty() || FindUnit(field.unit, dimension).has_value();
        if (!best && is_free && fits && LettersOf(field.name) == name) best = i;
      }
    }
    if (!best) continue;
    taken->push_back(channel.fields[*best].name);
    all.push_back({entry.column, channel.fields[*best], named.places[*best]});
  }
  return all;
}

const Found* Find(const std::vector<Found>& found, std::string_view column) {
  const auto at =
      std::find_if(found.begin(), found.end(), [&](const Found& f) { return f.column == column; });
  return at == found.end() ? nullptr : &*at;
}

bool Has(const std::vector<Found>& found, std::string_view column) {
  return Find(found, column) != nullptr;
}

// Two forces side by side become that of surge, unless forces on the vehicle are there too.
std::vector<Found> WithSidesAdded(std::vector<Found> found) {
  const Found* port = Find(found, kPort);
  const Found* starboard = Find(found, kStarboard);
  if (port != nullptr && starboard != nullptr && found.size() == 2 &&
      port->field.unit == starboard->field.unit) {
    return {{"tau_surge", port->field, port->place, starboard->place.field}};
  }
  std::erase_if(found, [](const Found& f) { return f.column == kPort || f.column == kStarboard; });
  return found;
}

// Quoted where YAML would read something else.
std::string YamlText(const std::string& text) {
  const bool is_plain = !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '/';
  });
  const bool is_word = LettersOf(text) == "y" || LettersOf(text) == "n" || ParseFiniteNumber(text);
  if (is_plain && !is_word) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += ShownOnOneLine({&c, 1});  // \x.. is YAML's own
  }
  return quoted + "\"";
}

std::string StreamText(const char* stream,
                       const NamedChannel& named,
                       bool names_channel,
                       const char* frame,
                       const std::vector<Found>& found) {
  std::string text = fmt::format("{}:\n", stream);
  const std::string& channel = found.front().place.channel;
  if (names_channel) text += fmt::format("  channel: {}\n", YamlText(channel));
  if (!named.time_channel.empty()) {
    text += fmt::format("  time: {{channel: {}, field: value, unit: s}}  # is it this?\n",
                        YamlText(named.time_channel));
  } else if (!named.channel.first) {
    text += "  rate: 10  # Hz: there are no stamps. What is it?\n";
  }
  text += frame;
  for (const Found& f : found) {
    if (!f.added.empty()) {
      text += fmt::format(
          "  {}: {{sum: [{}, {}], unit: {}}}  # both push ahead: is it this? Moments need a "
          "vehicle "
          "file: thruster_1, thruster_2\n",
          f.column,
          YamlText(f.place.field),
          YamlText(f.added),
          f.field.unit.empty() ? "N" : YamlText(f.field.unit));
    } else if (f.field.unit.empty()) {
      const std::string_view unit = SiUnit(DimensionOf(f.column).value_or(Dimension::kForce));
      text += fmt::format(
          "  {}: {{{}field: {}, unit: {}}}  # states no unit: is it this?\n",
          f.column,
          f.place.channel == channel ? "" : fmt::format("channel: {}, ", YamlText(f.place.channel)),
          YamlText(f.place.field),
          unit);
    } else {
      text += fmt::format("  {}: {}  # [{}]\n", f.column, YamlText(f.place.field), f.field.unit);
    }
  }
  return text;
}

// "# The stamps are the column Time [ms].", of each channel whose stamps are one.
std::string ClocksText(const std::vector<NamedChannel>& channels, bool names_channel) {
  std::string text;
  for (const NamedChannel& named : channels) {
    const std::optional<Field>& clock = named.channel.clock;
    if (!clock) continue;
    text += fmt::format("# The stamps{} are the column {}{}.\n",
                        names_channel ? " of " + Printable(named.channel.name) : "",
                        Printable(clock->name),
                        clock->unit.empty() ? "" : fmt::format(" [{}]", Printable(clock->unit)));
  }
  return text;
}

// The fields of one channel for one stream, if they make one.
struct StreamGuess {
  const NamedChannel* channel = nullptr;
  std::vector<Found> found;
};

}  // namespace

SuggestedMap MapByNames(const Contents& contents) {
  SuggestedMap map;
  map.text =
      "# By the names of the fields. Look at each line: units, signs and axes are yours to know.\n";
  const bool names_channel = contents.channels.size() > 1;
  std::vector<std::string> unused;
  const auto command_names = NamesOfStream("command");
  const auto velocity_names = NamesOfStream("velocity");
  const auto pose_names = NamesOfStream("pose");
  StreamGuess command;
  StreamGuess velocity;
  StreamGuess pose;
  const auto keep_better =
      [](const NamedChannel& channel, std::vector<Found> found, StreamGuess* guess) {
        if (found.size() > guess->found.size()) *guess = {&channel, std::move(found)};
      };
  const std::vector<NamedChannel> channels = NamedChannels(contents);
  map.text += ClocksText(channels, names_channel);
  for (const NamedChannel& channel : channels) {
    std::vector<std::string> taken;
    if (channel.channel.clock) taken.push_back(channel.channel.clock->name);
    keep_better(channel, WithSidesAdded(FindByNames(command_names, channel, &taken)), &command);
    std::vector<Found> of_pose = FindByNames(pose_names, channel, &taken);
    const bool has_position = Has(of_pose, "x") && Has(of_pose, "y");
    const bool is_pose = Has(of_pose, "qw") || (has_position && Has(of_pose, "yaw")) ||
                         (Has(of_pose, "roll") && Has(of_pose, "pitch"));
    if (!has_position) {
      std::erase_if(of_pose, [](const Found& f) { return f.column == "x" || f.column == "y"; });
    }
    if (Has(of_pose, "qw")) {
      std::erase_if(of_pose, [](const Found& f) {
        return f.column == "roll" || f.column == "pitch" || f.column == "yaw";
      });
    }
    if (is_pose) keep_better(channel, std::move(of_pose), &pose);
    keep_better(channel, FindByNames(velocity_names, channel, &taken), &velocity);
    for (std::size_t i = 0; i < channel.places.size(); ++i) {
      const FieldPlace& place = channel.places[i];
      const std::string& name = channel.channel.fields[i].name;
      if (std::find(taken.begin(), taken.end(), name) == taken.end() &&
          place.channel != channel.time_channel) {
        unused.push_back(names_channel ? place.channel + " " + place.field : place.field);
      }
    }
  }
  if (command.channel != nullptr) {
    map.text += StreamText("command",
                           *command.channel,
                           names_channel,
                           "  frame: FRD  # or FLU: y to the left, z up\n",
                           command.found);
  } else {
    map.text += "# command: {tau_surge: ...}  # which field is the thrust?\n";
  }
  if (velocity.channel != nullptr) {
    map.text += StreamText("velocity",
                           *velocity.channel,
                           names_channel,
                           "  frame: FRD  # or FLU; NED, ENU, NWU: along the world's axes\n",
                           velocity.found);
  }
  if (pose.channel != nullptr) {
    map.text += StreamText(
        "pose", *pose.channel, names_channel, "  frame: NED  # or ENU, NWU: z up\n", pose.found);
  }
  if (velocity.channel == nullptr && pose.channel == nullptr) {
    map.text += "# velocity: {u: ...}  # which field is the motion?\n";
  }
  constexpr std::size_t kMostUnused = 30;
  if (!unused.empty()) map.text += "# not used:";
  for (std::size_t i = 0; i < std::min(unused.size(), kMostUnused); ++i) {
    map.text += (i == 0 ? " " : ", ") + Printable(unused[i]);
  }
  if (unused.size() > kMostUnused) map.text += ", ...";
  if (!unused.empty()) map.text += "\n";
  return map;
}

}  // namespace fathom
