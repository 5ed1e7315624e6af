// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/dives/archive_settings.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/files/path_text.h"
#include "fathom/base/files/yaml_file.h"
#include "fathom/base/quoted.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <regex>
#include <system_error>

#include <fmt/format.h>
#include <fnmatch.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;

// Whether a count in braces has over three digits: the standard library's reader of patterns has
// no limit of its own, and overflows.
bool HasLargeCount(const std::string& pattern) {
  constexpr std::ptrdiff_t kMostDigits = 3;
  for (std::size_t open = pattern.find('{'); open != std::string::npos;
       open = pattern.find('{', open + 1)) {
    std::ptrdiff_t num_digits = 0;
    for (std::size_t i = open + 1; i < pattern.size() && pattern[i] != '}'; ++i) {
      num_digits = std::isdigit(static_cast<unsigned char>(pattern[i])) != 0 ? num_digits + 1 : 0;
      if (num_digits > kMostDigits) return true;
    }
  }
  return false;
}

bool IsRegularExpression(const std::string& pattern) {
  try {
    std::regex check(pattern);
  } catch (const std::regex_error&) {
    return false;
  }
  return true;
}

std::string DivePatternOf(const YamlMap& file) {
  std::string pattern = file.String("dive_pattern", "");
  if (HasLargeCount(pattern)) {
    file.Fail("dive_pattern", fmt::format("is {}, expected counts below 1000.", Quoted(pattern)));
  }
  if (!IsRegularExpression(pattern)) {
    file.Fail(
        "dive_pattern",
        fmt::format("is {}, expected a regular expression as [0-9]{{4}}-[0-9]{{2}}-[0-9]{{2}}.",
                    Quoted(pattern)));
  }
  return pattern;
}

std::optional<int> DiveLevelOf(const YamlMap& file) {
  if (!file.Has("dive_level")) return std::nullopt;
  const auto level = file.Integer("dive_level");
  if (level < 1 || level > 100) {
    file.Fail("dive_level",
              fmt::format("is {}, expected a level of the path, from 1 on: 1 is the folder in the "
                          "archive itself.",
                          level));
  }
  return static_cast<int>(level);
}

std::optional<Dof> DofOf(const YamlMap& file) {
  if (!file.Has("dof")) return std::nullopt;
  const std::string name = file.String("dof");
  const auto dof = DofFromName(name);
  if (!dof) {
    file.Fail("dof",
              fmt::format("is {}, expected surge, sway, heave, roll, pitch or yaw.", Quoted(name)));
  }
  return dof;
}

ArchiveImport ImportIn(const YamlMap& entry, const fs::path& archive, const fs::path& vehicle) {
  ArchiveImport import;
  import.files = entry.String("files");
  const std::string map = entry.String("map", ""), own_vehicle = entry.String("vehicle", "");
  if (!map.empty()) import.map = archive / map;
  import.vehicle = own_vehicle.empty() ? vehicle : archive / own_vehicle;
  entry.Finish();
  return import;
}

bool IsMatch(const std::string& pattern, const std::string& path) {
  return fnmatch(pattern.c_str(), path.c_str(), 0) == 0;
}

}  // namespace

ArchiveSettings ParseArchiveSettings(const fs::path& name, const std::string& text) {
  const YamlMap file = ParseYaml(name.string(), text);
  ArchiveSettings settings;
  settings.dive_level = DiveLevelOf(file);
  settings.dive_pattern = DivePatternOf(file);
  if (settings.dive_level && !settings.dive_pattern.empty()) {
    file.Fail("dive_pattern", "stands beside dive_level, expected one of them.");
  }
  settings.vehicle_name = file.String("vehicle", "");
  if (!settings.vehicle_name.empty()) settings.vehicle = name.parent_path() / settings.vehicle_name;
  settings.dof = DofOf(file);
  for (const YamlMap& entry : file.OptionalMaps("imports")) {
    settings.imports.push_back(ImportIn(entry, name.parent_path(), settings.vehicle));
  }
  if (file.Has("leave_out")) settings.leave_out = file.Strings("leave_out");
  file.Finish();
  return settings;
}

ArchiveSettings ReadArchiveSettings(const fs::path& archive) {
  const fs::path path = archive / "archive.yaml";
  std::error_code error;
  if (!fs::exists(path, error)) return {};
  return ParseArchiveSettings(path, ReadFile(path));
}

std::string DiveOfPath(const fs::path& path, const ArchiveSettings& settings) {
  const std::string text = PathText(path);
  if (!settings.dive_pattern.empty()) {
    std::smatch match;
    if (std::regex_search(text, match, std::regex(settings.dive_pattern))) return match.str();
  } else if (settings.dive_level) {
    const auto levels = std::distance(path.begin(), path.end());
    if (*settings.dive_level < levels)
      return PathText(*std::next(path.begin(), *settings.dive_level - 1));
  } else if (path.has_parent_path()) {
    return PathText(path.parent_path());
  }
  return text;
}

const ArchiveImport* ImportOf(const std::string& path, const ArchiveSettings& settings) {
  const auto found = std::find_if(
      settings.imports.begin(), settings.imports.end(), [&](const ArchiveImport& import) {
        return IsMatch(import.files, path);
      });
  return found == settings.imports.end() ? nullptr : &*found;
}

bool IsLeftOut(const std::string& path, const ArchiveSettings& settings) {
  return std::any_of(settings.leave_out.begin(),
                     settings.leave_out.end(),
                     [&](const auto& pattern) { return IsMatch(pattern, path); });
}

}  // namespace fathom
