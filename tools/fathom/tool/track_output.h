// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"
#include "fathom/log/remark.h"
#include "fathom/marker_trajectory/marker_trajectory.h"

#include <filesystem>
#include <span>

namespace fathom {

// The files of fathom_track; docs/file_formats.md, "What fathom_track writes".

// pose.csv with deviations and, if there is something to say of the poses, pose.yaml.
void WriteTrack(const std::filesystem::path& folder,
                const MarkerTrack& track,
                std::span<const Remark> remarks);

// Takes over into a new log what belongs to the track of `log` beside that: log.yaml, without a
// video that is not in the new log, streams, vehicle, calibration, mount, and the markers: where
// some were estimated, with the places that the poses rest on.
void CopyLog(const Log& log, const MarkerTrack& track, const std::filesystem::path& to);

}  // namespace fathom
