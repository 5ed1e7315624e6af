// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/map/camera_map.h"

#include "fathom/base/files/leaves_its_folder.h"
#include "fathom/base/quoted.h"
#include "fathom/base/utc_time.h"

#include <filesystem>
#include <string_view>

#include <fmt/format.h>

namespace fathom {

std::array<std::pair<std::string, std::string>, 4> CameraMap::Files() const {
  return {{{std::filesystem::path(video).filename().string(), video},
           {"camera.yaml", calibration},
           {"tags.yaml", tags},
           {"mount.yaml", mount}}};
}

CameraMap CameraMapOf(const YamlMap& map) {
  CameraMap camera;
  camera.video = map.String("video");
  if (std::filesystem::path(camera.video).filename().empty()) {
    map.Fail("video", "names a folder, expected a video.");
  }
  camera.calibration = map.String("calibration", "camera.yaml");
  camera.tags = map.String("tags", "tags.yaml");
  camera.mount = map.String("mount", "mount.yaml");
  // As log.yaml's files: a map that came from elsewhere takes none but its own.
  const std::array<std::pair<std::string_view, const std::string*>, 4> files = {
      {{"video", &camera.video},
       {"calibration", &camera.calibration},
       {"tags", &camera.tags},
       {"mount", &camera.mount}}};
  for (const auto& [key, file] : files) {
    if (!LeavesItsFolder(*file)) continue;
    map.Fail(
        key,
        fmt::format("is {}, expected a path from the map's folder on that stays in it. Put the "
                    "file beside the map.",
                    Quoted(*file)));
  }
  if (!map.Has("start")) return camera;
  if (const auto utc = ParseUtc(map.String("start"))) {
    camera.start = *utc;
    camera.is_utc = true;
  } else {
    camera.start = map.Number("start");
  }
  return camera;
}

}  // namespace fathom
