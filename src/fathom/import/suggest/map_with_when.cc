// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/suggest/map_with_when.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/files/yaml_file.h"
#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"
#include "fathom/import/map/import_map.h"
#include "fathom/import/recording/data_files.h"
#include "fathom/import/suggest/channel_facts.h"
#include "fathom/import/suggest/filled_map.h"

#include <algorithm>
#include <sstream>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

std::vector<std::string> StringsOf(const YamlMap& map, std::string_view key) {
  return map.Has(key) ? map.Strings(key) : std::vector<std::string>();
}

std::optional<double> NumberOf(const YamlMap& map, std::string_view key) {
  return map.Has(key) ? std::optional(map.Number(key)) : std::nullopt;
}

WantedChannel WantedOf(const YamlMap& map) {
  WantedChannel wanted;
  wanted.name = map.String("name", "");
  wanted.type = map.String("type", "");
  wanted.field = map.String("field", "");
  wanted.above = NumberOf(map, "above");
  wanted.below = NumberOf(map, "below");
  wanted.outputs = map.String("outputs", "");
  wanted.motors = map.String("motors", "");
  wanted.reach = map.Number("reach", 0.0);
  wanted.is_idle_too = map.Boolean("idle", false);
  wanted.also = StringsOf(map, "also");
  wanted.text = map.String("text", "");
  if (wanted.name.empty() && wanted.type.empty() && wanted.field.empty()) {
    map.Fail("says nothing of the channel, expected some of name, type, field.");
  }
  if ((wanted.above || wanted.below) && wanted.field.empty()) map.Fail("names no field.");
  return wanted;
}

bool HoldsChannel(const Contents& contents, const std::string& name) {
  return std::ranges::any_of(contents.channels,
                             [&](const Channel& channel) { return channel.name == name; });
}

}  // namespace

struct MapWithWhen::When {
  std::vector<std::string> formats, channels, fields;
  std::vector<std::string> has, needs_vehicle, ready;  // conditions of what was found
  bool is_ever_ready = false;
  WantedChannels find;
  bool takes_most = false;
  std::string looks_for;
  MapLines lines;
};

MapWithWhen::MapWithWhen(const std::string& name, const std::string& text) {
  std::istringstream lines(text);
  std::string text_of_when;
  MapLines others;
  bool is_of_when = false;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (!line.empty() && line.front() != ' ') is_of_when = line.starts_with("when:");
    text_of_when += (is_of_when ? line : "") + "\n";
    if (!is_of_when) others.push_back({number, line});
  }
  auto parsed = std::make_shared<When>();
  // With lines for several kinds of recordings the text need not be one map.
  const bool has_choices = HasChoices(others);
  const YamlMap file = ParseYaml(name, has_choices ? text_of_when : text);
  const YamlMap when = file.Map("when");
  parsed->formats = StringsOf(when, "format");
  parsed->channels = StringsOf(when, "channels");
  parsed->fields = StringsOf(when, "fields");
  parsed->has = StringsOf(when, "has");
  parsed->needs_vehicle = StringsOf(when, "needs_vehicle");
  const std::vector<std::string> ready = StringsOf(when, "ready");
  const bool is_always_ready = ready == std::vector<std::string>{"true"};
  parsed->is_ever_ready = !ready.empty() && ready != std::vector<std::string>{"false"};
  if (parsed->is_ever_ready && !is_always_ready) parsed->ready = ready;
  const std::string take = when.String("take", "first");
  parsed->takes_most = take == "most";
  if (take != "first" && take != "most") when.Fail("take", "is neither 'first' nor 'most'.");
  parsed->looks_for = when.String("looks_for", "");
  if (const auto find = when.OptionalMap("find")) {
    for (const std::string& channel : find->Keys()) {
      if (channel == "channel" || channel == "thrusters" || channel == "vehicle") {
        find->Fail(channel, "has a meaning of its own, expected another name.");
      }
      for (const YamlMap& way : find->Maps(channel)) {
        parsed->find[channel].push_back(WantedOf(way));
      }
    }
  }
  when.Finish();
  if (parsed->formats.empty() && parsed->channels.empty() && parsed->fields.empty() &&
      parsed->has.empty()) {
    when.Fail("names no condition, expected some of format, channels, fields, has.");
  }
  for (const auto& conditions : {parsed->has, parsed->needs_vehicle, parsed->ready}) {
    const std::string unknown = UnknownCondition(conditions, parsed->find);
    if (!unknown.empty()) when.Fail(fmt::format("'find' holds no {}.", Quoted(unknown)));
  }
  CheckLines(name, others, parsed->find);
  if (!has_choices) ParseImportMap(name, text);
  parsed->lines = std::move(others);
  when_ = std::move(parsed);
}

std::optional<SuggestedMap> MapWithWhen::For(const Recording& recording,
                                             const std::optional<Vehicle>& vehicle) const {
  const Contents& contents = recording.contents();
  const auto is_there = [&](const std::string& name) { return HoldsChannel(contents, name); };
  if (!when_->formats.empty() &&
      std::ranges::find(when_->formats, contents.format) == when_->formats.end()) {
    return std::nullopt;
  }
  if (!std::ranges::all_of(when_->channels, is_there)) return std::nullopt;
  const auto holds_all = [&](const Channel& channel) {
    return std::ranges::all_of(when_->fields,
                               [&](const std::string& field) { return HasField(channel, field); });
  };
  const auto with_fields = std::ranges::find_if(contents.channels, holds_all);
  if (!when_->fields.empty() && with_fields == contents.channels.end()) return std::nullopt;
  FilledMap filled(FoundChannels(recording, when_->find, when_->takes_most), vehicle);
  if (!filled.Meets(when_->has)) return std::nullopt;
  if (with_fields != contents.channels.end() && contents.channels.size() > 1) {
    filled.SetChannel(with_fields->name);
  }
  SuggestedMap map;
  map.text = filled.TextOf(when_->lines);
  map.is_ready = when_->is_ever_ready && filled.Meets(when_->ready);
  if (!when_->needs_vehicle.empty() && filled.Meets(when_->needs_vehicle)) {
    map.needs_vehicle = !vehicle;
    filled.TellWhyNotDriven(&map);
  }
  filled.TellUnknown(&map);
  return map;
}

std::string_view MapWithWhen::LooksFor(std::string_view format) const {
  const bool is_for_it = std::ranges::find(when_->formats, format) != when_->formats.end();
  return is_for_it ? std::string_view(when_->looks_for) : std::string_view();
}

std::vector<MapWithWhen> ReadMapsWithWhen(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  if (error) throw InputError(fmt::format("{}: {}.", folder.string(), error.message()));
  if (files.empty()) {
    throw InputError(
        fmt::format("{}: holds no .yaml, expected maps with `when:`.", folder.string()));
  }
  std::ranges::sort(files);
  std::vector<MapWithWhen> maps;
  for (const auto& file : files) maps.emplace_back(file.string(), ReadFile(file));
  return maps;
}

std::span<const MapWithWhen> KnownMaps() {
  using namespace data_files;
  static const auto* const kMaps =
      new std::vector<MapWithWhen>{{"ardupilot.yaml", std::string(ardupilot)},
                                   {"moos.yaml", std::string(moos)},
                                   {"px4.yaml", std::string(px4)},
                                   {"rock.yaml", std::string(rock)},
                                   {"ros.yaml", std::string(ros)},
                                   {"tlog.yaml", std::string(tlog)},
                                   {"uvms_simlab.yaml", std::string(uvms_simlab)}};
  return *kMaps;
}

}  // namespace fathom
