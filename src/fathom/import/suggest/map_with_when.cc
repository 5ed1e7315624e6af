// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/suggest/map_with_when.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/files/yaml_file.h"
#include "fathom/base/input_error.h"
#include "fathom/base/quoted.h"
#include "fathom/import/map/import_map.h"
#include "fathom/import/suggest/channel_facts.h"
#include "fathom/import/suggest/map_files.h"

#include <algorithm>
#include <sstream>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::string_view kChannel = "{channel}";

std::vector<std::string> StringsOf(const YamlMap& map, std::string_view key) {
  return map.Has(key) ? map.Strings(key) : std::vector<std::string>();
}

// For a place between double quotes.
std::string EscapedInYaml(const std::string& name) {
  std::string text;
  for (const char c : name) {
    if (c == '"' || c == '\\') text += '\\';
    text += ShownOnOneLine({&c, 1});  // \x.. is YAML's own
  }
  return text;
}

bool HoldsChannel(const Contents& contents, const std::string& name) {
  return std::ranges::any_of(contents.channels,
                             [&](const Channel& channel) { return channel.name == name; });
}

}  // namespace

MapWithWhen::MapWithWhen(const std::string& name, std::string text) : text_(std::move(text)) {
  const YamlMap file = ParseYaml(name, text_);
  const YamlMap when = file.Map("when");
  formats_ = StringsOf(when, "format");
  channels_ = StringsOf(when, "channels");
  fields_ = StringsOf(when, "fields");
  is_ready_ = when.Boolean("ready", false);
  when.Finish();
  if (formats_.empty() && channels_.empty() && fields_.empty()) {
    when.Fail("names no condition, expected some of format, channels, fields.");
  }
  ParseImportMap(name, text_);
}

std::optional<SuggestedMap> MapWithWhen::For(const Contents& contents) const {
  const auto is_there = [&](const std::string& name) { return HoldsChannel(contents, name); };
  if (!formats_.empty() && std::ranges::find(formats_, contents.format) == formats_.end()) {
    return std::nullopt;
  }
  if (!std::ranges::all_of(channels_, is_there)) return std::nullopt;
  const auto holds_all = [&](const Channel& channel) {
    return std::ranges::all_of(
        fields_, [&](const std::string& field) { return HasField(contents, channel.name, field); });
  };
  const auto found = std::ranges::find_if(contents.channels, holds_all);
  if (found == contents.channels.end()) return std::nullopt;
  SuggestedMap map;
  map.text = TextFor(found->name, contents.channels.size() == 1);
  map.is_ready = is_ready_;
  return map;
}

std::string MapWithWhen::TextFor(const std::string& channel, bool is_only_channel) const {
  std::istringstream lines(text_);
  std::string text;
  bool is_of_when = false;
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line.front() != ' ') is_of_when = line.starts_with("when:");
    const std::size_t place = line.find(kChannel);
    if (is_of_when || (place != std::string::npos && is_only_channel)) continue;
    if (place != std::string::npos) line.replace(place, kChannel.size(), EscapedInYaml(channel));
    text += line + "\n";
  }
  return text;
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

const MapWithWhen& UvmsSimlabMap() {
  static const MapWithWhen kMap("uvms_simlab.yaml", std::string(map_files::uvms_simlab_yaml));
  return kMap;
}

}  // namespace fathom
