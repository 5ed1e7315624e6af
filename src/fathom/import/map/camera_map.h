// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/files/yaml_file.h"

#include <array>
#include <string>
#include <utility>

namespace fathom {

// The video that belongs to a recording, and what turns it into poses; docs/import.md. Files are
// named from the map's folder on.
struct CameraMap {
  std::string video;
  std::string calibration;
  std::string tags;
  std::string mount;
  double start = 0.0;   // when the video's own clock is at 0 [s]
  bool is_utc = false;  // `start` is since 1970; else in the time of the log

  // Each file by its name in a log folder.
  std::array<std::pair<std::string, std::string>, 4> Files() const;
};

// `map`: what stands below `camera`. Throws InputError, naming file, line and key.
CameraMap CameraMapOf(const YamlMap& map);

}  // namespace fathom
