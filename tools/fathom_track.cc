// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The trajectory of a vehicle from the markers that its camera sees.
//
//   fathom_track --log=LOG [--out=LOG --overlay=FILE --summary=FILE.json]

#include "fathom/base/files/input_file.h"
#include "fathom/base/files/output_file.h"
#include "fathom/base/files/temporary.h"
#include "fathom/base/input_error.h"
#include "fathom/camera/camera_rig.h"
#include "fathom/camera/detections_file.h"
#include "fathom/camera/tags_file.h"
#include "fathom/detect/detect_tags.h"
#include "fathom/images/frame_list.h"
#include "fathom/log/log_clocks.h"
#include "fathom/log/pose_remarks.h"
#include "fathom/log/read_log.h"
#include "fathom/marker_trajectory/marker_trajectory.h"
#include "fathom/tool/output_flags.h"
#include "fathom/tool/output_folder.h"
#include "fathom/tool/progress.h"
#include "fathom/tool/tool.h"
#include "fathom/tool/track_output.h"
#include "fathom/tool/track_overlay.h"
#include "fathom/tool/track_summary.h"
#include "fathom/track/overlay.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gflags/gflags.h>

DEFINE_string(log, "", "Log folder with images or a video, camera.yaml, tags.yaml and mount.yaml.");
DEFINE_string(out,
              "",
              "Folder of a new log with detections.csv and pose.csv and the files of --log but its "
              "images. Without it they are written into --log.");
DEFINE_bool(overwrite,
            false,
            "Replace the log in --out, unless it holds images, or the files of an earlier track in "
            "--log.");
DEFINE_string(from,
              "",
              "Start from `images` or from `detections` (detections.csv). Not given: from "
              "detections if the log holds them.");
DEFINE_string(overlay, "", "Draw what was found into this video (.mp4, .avi) or sheet (.png).");
DEFINE_string(summary, "", "Write the account of every frame and detection to this file (JSON).");
DEFINE_bool(estimate_markers,
            false,
            "Estimate the places of all markers but one from the images, also of those surveyed.");
DEFINE_int32(reference,
             -1,
             "The marker that then stays in its place. Not given: the one seen most.");
DEFINE_double(gate,
              4.0,
              "Detections further off than this, in corner sigmas, are outliers. More where the "
              "survey or the lens is only roughly known.");
DEFINE_uint32(max_hamming, 0, "Bits of a tag's code that may be wrong: 0, 1 or 2.");
DEFINE_double(
    quad_decimate,
    1.0,
    "Look for tags in images smaller by this factor, 1.5 or a whole number to 16: faster.");
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
        "Exit code 2: fewer than two frames have a pose. docs/vision.md describes the detection, "
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

bool IsGiven(const char* flag) { return !gflags::GetCommandLineFlagInfoOrDie(flag).is_default; }

// Refuses flags of the detection where there is none.
void RequireNoDetectionFlags(const fs::path& folder) {
  for (const char* flag : {"max_hamming", "quad_decimate", "quad_sigma", "threads"}) {
    if (!IsGiven(flag)) continue;
    throw InputError(fmt::format(
        "--{}: is about the detection, but the track starts from {}, expected --from=images too.",
        flag,
        (folder / "detections.csv").string()));
  }
}

TagDetectorOptions DetectorOptionsFromFlags() {
  TagDetectorOptions options;
  options.max_hamming = static_cast<int>(FLAGS_max_hamming);
  options.quad_decimate = FLAGS_quad_decimate;
  options.quad_sigma = FLAGS_quad_sigma;
  constexpr std::uint32_t kMostThreads = 256;
  if (FLAGS_threads < 1 || FLAGS_threads > kMostThreads) {
    throw InputError(
        fmt::format("--threads: is {}, expected 1 to {}.", FLAGS_threads, kMostThreads));
  }
  options.num_threads = static_cast<int>(FLAGS_threads);
  // The other options have the names of their flags.
  if (const auto problems = options.Problems(); !problems.empty()) {
    throw InputError(fmt::format("--{}.", problems.front()));
  }
  return options;
}

MarkerTrajectoryOptions TrajectoryOptionsFromFlags() {
  MarkerTrajectoryOptions options;
  options.estimate_surveyed_markers = FLAGS_estimate_markers;
  if (!(FLAGS_gate > 0.0)) {
    throw InputError(fmt::format("--gate: is {}, expected a number above 0.", FLAGS_gate));
  }
  options.pose_track.gate = FLAGS_gate;
  if (IsGiven("reference")) {
    if (!FLAGS_estimate_markers) {
      throw InputError(fmt::format(
          "--reference={}: stands without --estimate_markers, expected both: it is the marker that "
          "keeps its place while the others are estimated.",
          FLAGS_reference));
    }
    options.reference_id = FLAGS_reference;
  }
  return options;
}

// Names the flag and the file, before the frames are read.
void RequireReference(const MarkerTrajectoryOptions& options,
                      const MarkerMap& map,
                      const fs::path& tags_file) {
  if (!options.reference_id) return;
  std::vector<int> surveyed;
  for (const Marker& marker : map.markers) {
    if (marker.is_surveyed) surveyed.push_back(marker.id);
    if (marker.is_surveyed && marker.id == *options.reference_id) return;
  }
  throw InputError(fmt::format("--reference={}: is no surveyed tag of {}, expected one of {}.",
                               *options.reference_id,
                               tags_file.string(),
                               fmt::join(surveyed, ", ")));
}

// No output may take the place of what the log was filmed as.
void RequireOtherThanFrames(const fs::path& folder, const Log& log) {
  std::vector<std::string> files = {log.video};
  if (const fs::path list = folder / "frames.csv"; log.video.empty() && Exists(list)) {
    for (const ListedFrame& frame : ParseFrameList(list.string(), ReadFile(list)).frames) {
      files.push_back(frame.file);
    }
  }
  for (const auto& [flag, output] :
       {std::pair("overlay", FLAGS_overlay), std::pair("summary", FLAGS_summary)}) {
    if (output.empty() || !Exists(output)) continue;
    for (const std::string& file : files) {
      std::error_code error;
      if (file.empty() || !fs::equivalent(output, folder / file, error)) continue;
      throw InputError(
          fmt::format("--{}={}: is what --log={} was filmed as, expected another file.",
                      flag,
                      output,
                      FLAGS_log));
    }
  }
}

// What both ways in need, and what comes of them.
struct Run {
  fs::path folder;
  Log log;
  CameraRig rig;
  std::string name;  // of the file that the detections come from
  std::optional<TagDetections> images;
  std::vector<Detection> detections;

  std::unique_ptr<FrameSource> Frames() const {
    return OpenFrames(folder, log.video, rig.camera, (folder / "camera.yaml").string());
  }
};

Run ReadRun(const fs::path& folder, const MarkerTrajectoryOptions& options) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    throw InputError(fmt::format("--log={}: is no folder, expected a log folder.", FLAGS_log));
  }
  Run run;
  run.folder = folder;
  ReadLogOptions log_options;
  log_options.may_lack_motion = true;
  log_options.may_lack_command = true;
  run.log = ReadLog(folder, log_options);
  // On poses that are made anew now.
  std::erase_if(run.log.remarks,
                [](const std::string& remark) { return remark.starts_with(kPoseRemark); });
  run.rig = ReadCameraRig(folder);
  run.log.remarks.insert(run.log.remarks.end(), run.rig.remarks.begin(), run.rig.remarks.end());
  RequireReference(options, run.rig.map, folder / "tags.yaml");
  RequireOtherThanFrames(folder, run.log);
  if (StartsFromDetections(folder)) {
    RequireNoDetectionFlags(folder);
    run.name = (folder / "detections.csv").string();
    run.detections = DetectionsOf(*run.log.detections);
    if (!FLAGS_overlay.empty()) run.Frames();  // refuses where there is nothing to draw on
    return run;
  }
  Progress progress("frame");
  const auto frames = run.Frames();
  run.name = frames->name();
  run.images = DetectTags(*frames,
                          run.rig.camera,
                          run.rig.map,
                          DetectorOptionsFromFlags(),
                          [&](int done, int expected) { progress.Show(done, expected); });
  run.detections = run.images->detections;
  return run;
}

// Frames on another clock than the command's would make a log that no tool reads. That of
// detections has been compared by whoever read the log.
void RequireOneClock(const Run& run, const MarkerTrack& track) {
  if (!run.images || !run.log.command) return;
  CsvTable command, poses;
  command.name = (run.folder / "command.csv").string();
  command.stream = *run.log.command;
  poses.name = run.name;
  for (const StampedPose& pose : track.world_from_body) poses.stream.time.push_back(pose.time);
  RefuseDisjointClocks(command, poses);
}

// Throws before any work is done if the result may not be written.
fs::path WhereToWrite(const fs::path& folder) {
  if (FLAGS_out.empty() && IsGiven("out")) {
    throw InputError("--out: is empty, expected a folder. Leave it out to write into the log.");
  }
  if (!FLAGS_out.empty()) {
    std::error_code error;
    if (fs::equivalent(FLAGS_out, folder, error)) {
      throw InputError("--out: is --log itself. Leave it out to write into the log.");
    }
    return OutputFolder(FLAGS_out, FLAGS_overwrite);
  }
  for (const char* file : {"pose.csv", "detections.csv", "tags_estimated.yaml"}) {
    const bool is_input = file == std::string("detections.csv") && StartsFromDetections(folder);
    if (!FLAGS_overwrite && !is_input && Exists(folder / file)) {
      throw InputError(fmt::format(
          "{}: is there already, expected --overwrite to replace it, or --out for a new log.",
          (folder / file).string()));
    }
  }
  return folder;
}

// Throws before any work is done if a file that was asked for cannot be written.
void RequireWritable(const fs::path& out) {
  if (!FLAGS_overlay.empty()) RequireOverlayEnding(FLAGS_overlay);
  RequireOutputs({{"overlay", FLAGS_overlay}, {"summary", FLAGS_summary}}, {FLAGS_log});
  if (FLAGS_out.empty()) {
    RequireWritableFile(out / "pose.csv");
  } else {
    RequireOutside(out, "overlay", FLAGS_overlay);
    RequireOutside(out, "summary", FLAGS_summary);
    RequireWritableFolder(out);
  }
}

std::unique_ptr<OverlayWriter> MakeOverlay(const Run& run, const MarkerTrack& track) {
  constexpr double kUsualRate = 10.0;  // [Hz]
  const auto frames = run.Frames();
  const double rate = frames->mean_rate();
  auto overlay = OpenOverlay(
      FLAGS_overlay, run.rig.camera.width, run.rig.camera.height, rate > 0.0 ? rate : kUsualRate);
  std::vector<std::string> remarks;
  {
    Progress progress("overlay frame");
    remarks = DrawOverlay(*frames,
                          run.rig.camera,
                          run.images,
                          run.detections,
                          track,
                          overlay.get(),
                          [&](int done, int expected) { progress.Show(done, expected); });
  }
  for (const std::string& remark : remarks) fmt::print(stderr, "{}\n", remark);
  return overlay;
}

int RunTrack() {
  const fs::path folder = RequireFlag("log", FLAGS_log, "a log folder with images");
  MarkerTrajectoryOptions options = TrajectoryOptionsFromFlags();
  const fs::path out = WhereToWrite(folder);
  RequireWritable(out);
  const Run run = ReadRun(folder, options);
  for (const std::string& remark : run.log.remarks) fmt::print(stderr, "{}\n", remark);
  if (run.images) {
    for (const std::string& problem : run.images->unreadable) fmt::print(stderr, "{}\n", problem);
    options.pose_track.frame_times = run.images->frame_times;
  }
  options.pose_track.name = run.name;
  const MarkerTrack track =
      TrackMarkers(run.detections, run.rig.camera, run.rig.map, run.rig.body_from_camera, options);
  constexpr std::size_t kFewestPoses = 2;  // of a pose.csv
  const bool is_usable = track.world_from_body.size() >= kFewestPoses;
  if (is_usable) RequireOneClock(run, track);
  const TrackSummary summary =
      Summarize(run.log.name, run.images, run.detections, run.rig.camera, run.rig.map, track);
  for (const std::string& remark : summary.remarks) fmt::print(stderr, "{}\n", remark);

  // All are made before the first takes its name: whatever fails leaves nothing behind.
  std::unique_ptr<OverlayWriter> overlay;
  if (!FLAGS_overlay.empty()) overlay = MakeOverlay(run, track);
  std::optional<Temporary> made;
  if (is_usable && !FLAGS_out.empty()) {
    made.emplace(out);
    CopyLog(run.log, track, made->path());
    WriteTrack(made->path(), track, summary.remarks);
    if (run.images) WriteDetections(made->path() / "detections.csv", run.detections);
  }
  if (!FLAGS_summary.empty()) WriteFile(FLAGS_summary, FormatJson(summary, track, run.detections));
  if (overlay) overlay->Finish();
  if (!is_usable) {
    fmt::print(
        stderr,
        "fathom_track: no usable trajectory: {}\n",
        track.IsUsable() ? "a single frame has a pose, expected two at least." : track.message);
    return 2;
  }
  if (made) {
    made->TakePlace();
  } else {
    if (run.images) WriteDetections(out / "detections.csv", run.detections);
    WriteTrack(out, track, summary.remarks);
    if (track.estimated_ids.empty()) {
      std::error_code error;
      fs::remove(out / "tags_estimated.yaml", error);  // of an earlier track
    } else {
      WriteFile(out / "tags_estimated.yaml", FormatTagsFile(track.map));
      fmt::print(stderr,
                 "{}: the places that the poses rest on. What reads corners reads tags.yaml: put "
                 "this file in its place, or write a new log (--out).\n",
                 (out / "tags_estimated.yaml").string());
    }
  }
  fmt::print("{:<20}{}\n{}", "log", out.string(), FormatText(summary, track));
  return 0;
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  return fathom::RunTool(argc, argv, fathom::kInfo, fathom::RunTrack);
}
