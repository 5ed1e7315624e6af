// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/track_output.h"

#include "fathom/base/files/exists.h"
#include "fathom/base/files/output_file.h"
#include "fathom/base/input_error.h"
#include "fathom/camera/tags_file.h"
#include "fathom/log/pose_remarks.h"
#include "fathom/log/write_log.h"

#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;

void Copy(const fs::path& from, const fs::path& to) {
  if (!Exists(from)) return;
  std::error_code error;
  fs::create_directories(to.parent_path(), error);
  fs::copy_file(from, to, error);
  if (error) {
    throw InputError(fmt::format("{}: cannot write this file: {}.", to.string(), error.message()));
  }
}

}  // namespace

void WriteTrack(const fs::path& folder, const MarkerTrack& track, std::span<const Remark> remarks) {
  WriteStream(folder / "pose.csv", PoseStreamOf(track.world_from_body));
  if (remarks.empty()) {
    std::error_code error;
    fs::remove(folder / "pose.yaml", error);  // on the poses that stood there before
  } else {
    WriteFile(folder / "pose.yaml", FormatPoseRemarks(remarks, track.world_from_body.size()));
  }
}

void CopyLog(const Log& log, const MarkerTrack& track, const fs::path& to) {
  for (const char* file :
       {"command.csv", "velocity.csv", "detections.csv", "camera.yaml", "mount.yaml"}) {
    Copy(log.path / file, to / file);
  }
  if (log.origin && !log.origin->map.empty())
    Copy(log.path / log.origin->map, to / log.origin->map);
  // A path from the log's folder, which may lead out of it.
  const fs::path vehicle = log.vehicle;
  const bool has_vehicle = vehicle.extension() == ".yaml" && Exists(log.path / vehicle);
  if (has_vehicle) Copy(log.path / vehicle, to / vehicle.filename());
  if (log.video.empty() && (!has_vehicle || vehicle == vehicle.filename())) {
    Copy(log.path / "log.yaml", to / "log.yaml");
  } else {
    Log changed = log;
    if (has_vehicle) changed.vehicle = vehicle.filename().string();
    changed.video.clear();
    WriteFile(to / "log.yaml", FormatLogYaml(changed));
  }
  if (track.estimated_ids.empty()) {
    Copy(log.path / "tags.yaml", to / "tags.yaml");
  } else {
    WriteFile(to / "tags.yaml",
              fmt::format("# Estimated by fathom_track: the places of {}.\n{}",
                          fmt::join(track.estimated_ids, ", "),
                          FormatTagsFile(track.map)));
  }
}

}  // namespace fathom
