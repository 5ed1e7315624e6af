// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The trajectory of a vehicle from the markers that its camera sees.
//
//   fathom_track --log=LOG [--out=LOG --overlay=FILE --summary=FILE.json]

#include "fathom/base/input_error.h"
#include "fathom/base/output_file.h"
#include "fathom/log/write_log.h"
#include "fathom/marker_trajectory/marker_trajectory.h"
#include "fathom/tools/output_folder.h"
#include "fathom/tools/progress.h"
#include "fathom/tools/tool.h"
#include "fathom/tools/track_summary.h"
#include "fathom/vision/camera_rig.h"
#include "fathom/vision/detect_tags.h"
#include "fathom/vision/detections_file.h"
#include "fathom/vision/overlay.h"
#include "fathom/vision/tags_file.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <gflags/gflags.h>

DEFINE_string(log, "", "Log folder with images or a video, camera.yaml, tags.yaml and mount.yaml.");
DEFINE_string(out,
              "",
              "Folder of a new log with detections.csv and pose.csv and the files of --log but its "
              "images. Without it both are written into --log.");
DEFINE_bool(overwrite, false, "Replace the log in --out, or the two files in --log.");
DEFINE_string(from,
              "",
              "Start from `images` or from `detections` (detections.csv). Not given: from "
              "detections if the log holds them.");
DEFINE_string(overlay, "", "Draw what was found into this video (.mp4, .avi) or sheet (.png).");
DEFINE_string(summary, "", "Write the account of every frame and detection to this file (JSON).");
DEFINE_bool(estimate_markers,
            false,
            "Estimate the places of all markers but one from the images, also of those surveyed.");
DEFINE_int32(reference, -1, "The marker that then stays in its place; -1: the one seen most.");
DEFINE_double(gate,
              4.0,
              "Detections further off than this, in corner sigmas, are outliers. More where the "
              "survey or the lens is only roughly known.");
DEFINE_uint32(max_hamming, 0, "Bits of a tag's code that may be wrong: 0, 1 or 2.");
DEFINE_double(quad_decimate, 1.0, "Look for tags in images smaller by this factor: faster.");
DEFINE_double(quad_sigma, 0.0, "Blur images by this before [px], against strong noise.");
DEFINE_uint32(threads, 1, "Threads for the detection.");

namespace fathom {
namespace {

namespace fs = std::filesystem;

const ToolInfo kInfo = {
    .name = "fathom_track",
    .summary = "Finds the trajectory of a vehicle from the markers that its camera sees.",
    .usage = "--log=LOG [--out=LOG --overlay=FILE --summary=FILE.json]",
    .example =
        "fathom_track --log=dive --out=dive_tracked --overlay=sheet.png --summary=track.json",
    .details =
        "Exit code 2: no frame has a pose. docs/vision.md describes the detection, "
        "docs/marker_trajectory.md the trajectory, docs/file_formats.md the files."};

bool Exists(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

bool StartsFromDetections(const fs::path& folder) {
  const bool has_detections = Exists(folder / "detections.csv");
  if (FLAGS_from.empty()) return has_detections;
  if (FLAGS_from != "images" && FLAGS_from != "detections") {
    throw InputError(fmt::format("--from: is '{}', expected images or detections.", FLAGS_from));
  }
  if (FLAGS_from == "detections" && !has_detections) {
    throw InputError(
        fmt::format("{}: holds no detections.csv. Leave out --from.", folder.string()));
  }
  return FLAGS_from == "detections";
}

TagDetectorOptions DetectorOptionsFromFlags() {
  TagDetectorOptions options;
  options.max_hamming = static_cast<int>(FLAGS_max_hamming);
  options.quad_decimate = FLAGS_quad_decimate;
  options.quad_sigma = FLAGS_quad_sigma;
  options.num_threads = static_cast<int>(FLAGS_threads);
  return options;
}

MarkerTrajectoryOptions TrajectoryOptionsFromFlags() {
  MarkerTrajectoryOptions options;
  options.estimate_surveyed_markers = FLAGS_estimate_markers;
  if (!(FLAGS_gate > 0.0)) {
    throw InputError(fmt::format("--gate: is {}, expected a number above 0.", FLAGS_gate));
  }
  options.pose_track.gate = FLAGS_gate;
  if (FLAGS_reference >= 0) options.reference_id = FLAGS_reference;
  return options;
}

// What both ways in need, and what comes of them.
struct Run {
  fs::path folder;
  Log log;
  CameraRig rig;
  std::optional<TagDetections> images;
  std::vector<Detection> detections;

  std::unique_ptr<FrameSource> Frames() const {
    return OpenFrames(folder, log.video, rig.camera, (folder / "camera.yaml").string());
  }
};

Run ReadRun(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    throw InputError(fmt::format("--log={}: is no folder, expected a log folder.", FLAGS_log));
  }
  Run run;
  run.folder = folder;
  ReadLogOptions options;
  options.may_lack_motion = true;
  options.may_lack_command = true;
  run.log = ReadLog(folder, options);
  run.rig = ReadCameraRig(folder);
  if (StartsFromDetections(folder)) {
    run.detections = DetectionsOf(*run.log.detections);
    return run;
  }
  Progress progress("frame");
  run.images = DetectTags(*run.Frames(),
                          run.rig.camera,
                          run.rig.map,
                          DetectorOptionsFromFlags(),
                          [&](int done, int expected) { progress.Show(done, expected); });
  run.detections = run.images->detections;
  return run;
}

// Where the track puts the corners of the markers that were detected.
std::vector<std::array<Eigen::Vector2d, 4>> PredictedCorners(const OverlayFrame& frame,
                                                             const CameraModel& camera,
                                                             const MarkerMap& map,
                                                             const Pose& world_from_camera) {
  std::vector<std::array<Eigen::Vector2d, 4>> predicted;
  for (const Detection& detection : frame.detections) {
    const Marker* marker = map.Find(detection.tag_id);
    if (marker == nullptr || !marker->is_surveyed) continue;
    const Pose camera_from_tag = world_from_camera.Inverse() * marker->world_from_tag;
    const auto corners_in_tag = CornersInTag(marker->size);
    auto& corners = predicted.emplace_back();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Eigen::Vector3d x_camera = camera_from_tag * corners_in_tag[i];
      corners[i] = Project(camera, x_camera);
    }
  }
  return predicted;
}

void DrawOverlay(const Run& run, const MarkerTrack& track, OverlayWriter* overlay) {
  const auto frames = run.Frames();
  const int num_frames =
      run.images ? static_cast<int>(run.images->frame_times.size()) : frames->num_expected();
  Progress progress("overlay frame");
  std::size_t next_detection = 0, next_unused = 0, next_pose = 0;
  const auto& poses = track.world_from_camera;
  int index = 0;
  for (ImageFrame image; frames->Next(&image); ++index) {
    OverlayFrame frame;
    frame.image = &image.image;
    while (next_detection < run.detections.size() &&
           run.detections[next_detection].time <= image.time) {
      const Detection& detection = run.detections[next_detection++];
      if (detection.time == image.time) frame.detections.push_back(detection);
    }
    while (run.images && next_unused < run.images->unused.size() &&
           run.images->unused[next_unused].time <= image.time) {
      frame.unused.push_back(run.images->unused[next_unused++]);
    }
    while (next_pose < poses.size() && poses[next_pose].time < image.time) ++next_pose;
    frame.caption = fmt::format("t {:.2f} s, {} tags", image.time, frame.detections.size());
    if (next_pose < poses.size() && poses[next_pose].time == image.time) {
      frame.predicted = PredictedCorners(frame, run.rig.camera, track.map, poses[next_pose].pose);
      const Eigen::Vector3d& p = track.world_from_body[next_pose].pose.translation;
      frame.caption += fmt::format(", x {:.2f} y {:.2f} z {:.2f} m, rms {:.2f} px",
                                   p.x(),
                                   p.y(),
                                   p.z(),
                                   track.frame_rms[next_pose]);
    } else {
      frame.caption += ", no pose";
    }
    if (overlay->Wants(index, num_frames)) overlay->Add(frame);
    progress.Show(index + 1, num_frames);
  }
}

double RateOf(const std::vector<double>& times) {
  if (times.size() < 2 || !(times.back() > times.front())) return 10.0;
  return (static_cast<double>(times.size()) - 1.0) / (times.back() - times.front());
}

void WriteTrack(const fs::path& folder, const Run& run, const MarkerTrack& track) {
  WriteDetections(folder / "detections.csv", run.detections);
  WriteStream(folder / "pose.csv", PoseStreamOf(track.world_from_body));
  if (!track.estimated_ids.empty()) {
    WriteFile(folder / "tags_estimated.yaml", FormatTagsFile(track.map));
  }
}

// The files of a log that are not its frames or the track.
void CopyLog(const fs::path& from, const fs::path& to) {
  for (const char* file :
       {"log.yaml", "command.csv", "velocity.csv", "camera.yaml", "tags.yaml", "mount.yaml"}) {
    if (!Exists(from / file)) continue;
    std::error_code error;
    fs::create_directories(to, error);
    fs::copy_file(from / file, to / file, error);
    if (error) {
      throw InputError(
          fmt::format("{}: cannot write this file: {}.", (to / file).string(), error.message()));
    }
  }
}

// Throws before any work is done if the result may not be written.
fs::path WhereToWrite(const fs::path& folder) {
  if (!FLAGS_out.empty()) {
    const fs::path out = OutputFolder(FLAGS_out, FLAGS_overwrite);
    std::error_code error;
    if (fs::equivalent(out, folder, error)) {
      throw InputError("--out: is --log itself. Leave it out to write into the log.");
    }
    return out;
  }
  for (const char* file : {"pose.csv", "detections.csv"}) {
    const bool is_input = file == std::string("detections.csv") && StartsFromDetections(folder);
    if (!FLAGS_overwrite && !is_input && Exists(folder / file)) {
      throw InputError(fmt::format(
          "{}: is there already, expected --overwrite to replace it, or --out for a new log.",
          (folder / file).string()));
    }
  }
  return folder;
}

int RunTrack() {
  const fs::path folder = RequireFlag("log", FLAGS_log, "a log folder with images");
  const fs::path out = WhereToWrite(folder);
  if (!FLAGS_overlay.empty()) RequireOverlayEnding(FLAGS_overlay);
  const Run run = ReadRun(folder);
  for (const std::string& remark : run.log.remarks) fmt::print(stderr, "{}\n", remark);
  if (run.images) {
    for (const std::string& problem : run.images->unreadable) fmt::print(stderr, "{}\n", problem);
  }
  MarkerTrajectoryOptions options = TrajectoryOptionsFromFlags();
  if (run.images) options.pose_track.frame_times = run.images->frame_times;
  const MarkerTrack track =
      TrackMarkers(run.detections, run.rig.camera, run.rig.map, run.rig.body_from_camera, options);
  for (const std::string& remark : track.remarks) fmt::print(stderr, "{}\n", remark);

  const TrackSummary summary =
      Summarize(run.log.name, run.images, run.detections, run.rig.camera, track);
  if (!FLAGS_overlay.empty()) {
    const auto times = run.images ? run.images->frame_times : std::vector<double>{};
    const auto overlay =
        OpenOverlay(FLAGS_overlay, run.rig.camera.width, run.rig.camera.height, RateOf(times));
    DrawOverlay(run, track, overlay.get());
    overlay->Finish();
  }
  if (!FLAGS_summary.empty()) WriteFile(FLAGS_summary, FormatJson(summary, track, run.detections));
  if (!track.IsUsable()) {
    fmt::print(stderr, "fathom_track: no usable trajectory: {}\n", track.message);
    return 2;
  }
  if (FLAGS_out.empty()) {
    WriteTrack(out, run, track);
  } else {
    const FolderInTheMaking made(out);
    CopyLog(folder, made.path());
    WriteTrack(made.path(), run, track);
    made.Finish();
  }
  fmt::print("{:<20}{}\n{}", "log", out.string(), FormatText(summary, track));
  return 0;
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  return fathom::RunTool(argc, argv, fathom::kInfo, fathom::RunTrack);
}
