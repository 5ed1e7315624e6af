// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/map/camera_map.h"

#include <filesystem>

namespace fathom {

// Throws InputError for a video that is none, or a calibration, tags or mount that are none: before
// anything of them stands in a log.
void RequireCameraFiles(const CameraMap& camera, const std::filesystem::path& from);

// Puts the video of the map, its calibration, tags and mount into the log's folder: a second name
// for the video's bytes where the disk allows it, as they may be many.
void TakeCameraFiles(const CameraMap& camera,
                     const std::filesystem::path& from,
                     const std::filesystem::path& to);

}  // namespace fathom
