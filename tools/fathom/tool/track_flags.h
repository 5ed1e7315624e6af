// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/marker_map.h"
#include "fathom/detect/tag_detector.h"
#include "fathom/marker_trajectory/marker_trajectory.h"

#include <filesystem>

namespace fathom {

// The flags of fathom_track that say how tags are looked for and poses are made from them.

// --max_hamming, --quad_decimate, --quad_sigma, --threads. Throws InputError for a value that
// cannot be used.
TagDetectorOptions DetectorOptionsFromFlags();

// Throws InputError if one of these is given where nothing is looked for: the track of the log
// `folder` starts from detections.csv.
void RequireNoDetectorFlags(const std::filesystem::path& folder);

// --estimate_markers, --reference, --gate. Throws InputError for a value that cannot be used.
MarkerTrajectoryOptions TrajectoryOptionsFromFlags();

// Throws InputError, naming the flag and `tags_file`, if --reference is no surveyed marker of it.
void RequireReference(const MarkerTrajectoryOptions& options,
                      const MarkerMap& map,
                      const std::filesystem::path& tags_file);

}  // namespace fathom
