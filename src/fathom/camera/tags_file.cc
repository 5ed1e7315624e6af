// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/camera/tags_file.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/files/yaml_file.h"
#include "fathom/base/quoted.h"
#include "fathom/camera/tag_family.h"
#include "fathom/camera/yaml_pose.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

std::string FamilyAt(const YamlMap& map) {
  const std::vector<std::string>& known = TagFamilies();
  std::string family = map.String("family");
  if (std::find(known.begin(), known.end(), family) == known.end()) {
    map.Fail("family",
             fmt::format("is {}, expected one of {}.", Quoted(family), fmt::join(known, ", ")));
  }
  return family;
}

double SizeAt(const YamlMap& map) {
  constexpr double kLargest = 20.0;  // [m]
  const double size = map.Number("size");
  if (!(size > 0.0 && size <= kLargest)) {
    map.Fail("size",
             fmt::format("is {}, expected the side of the square in metres, above 0 and at "
                         "most {}.",
                         size,
                         kLargest));
  }
  return size;
}

int IdAt(const YamlMap& map) {
  const std::int64_t id = map.Integer("id");
  if (id < 0 || id > std::numeric_limits<int>::max()) {
    map.Fail("id", fmt::format("is {}, expected a number from 0 on.", id));
  }
  return static_cast<int>(id);
}

void RequireIdOfFamily(const YamlMap& tag, const Marker& marker) {
  const int num = NumTagsOf(marker.family);
  if (marker.id < num) return;
  tag.Fail("id",
           fmt::format("is {}, expected one of {}: it has the ids from 0 to {}.",
                       marker.id,
                       marker.family,
                       num - 1));
}

}  // namespace

MarkerMap ReadTagsFile(const std::filesystem::path& path) {
  return ParseTagsFile(path.string(), ReadFile(path));
}

MarkerMap ParseTagsFile(const std::string& name, const std::string& text) {
  const YamlMap file = ParseYaml(name, text);
  std::string family;
  if (file.Has("family")) family = FamilyAt(file);
  MarkerMap map;
  for (const YamlMap& tag : file.Maps("tags")) {
    Marker marker;
    marker.id = IdAt(tag);
    if (map.Find(marker.id) != nullptr) {
      tag.Fail("id",
               fmt::format("is {}, which stands above already, expected each id once, also "
                           "across families: detections tell tags apart by id alone.",
                           marker.id));
    }
    marker.size = SizeAt(tag);
    marker.family = family.empty() || tag.Has("family") ? FamilyAt(tag) : family;
    RequireIdOfFamily(tag, marker);
    marker.is_surveyed = tag.Has("world_from_tag");
    if (marker.is_surveyed) marker.world_from_tag = PoseAt(tag, "world_from_tag");
    map.markers.push_back(marker);
  }
  file.Finish();
  const auto is_surveyed = [](const Marker& marker) { return marker.is_surveyed; };
  if (std::none_of(map.markers.begin(), map.markers.end(), is_surveyed)) {
    file.Fail("tags",
              "holds no tag with a world_from_tag, expected at least one: it says where the world "
              "is. Give one of them the pose you want it to have.");
  }
  return map;
}

std::string FormatTagsFile(const MarkerMap& map) {
  std::string text = "tags:\n";
  for (const Marker& marker : map.markers) {
    fmt::format_to(std::back_inserter(text),
                   "  - {{id: {}, size: {}, family: {}",
                   marker.id,
                   marker.size,
                   marker.family);
    if (marker.is_surveyed) text += ", world_from_tag: " + FormatYamlPose(marker.world_from_tag);
    text += "}\n";
  }
  return text;
}

}  // namespace fathom
