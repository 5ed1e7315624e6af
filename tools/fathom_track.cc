// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The trajectory of a vehicle from the markers that its camera sees.
//
//   fathom_track --log=LOG [--out=LOG --overlay=FILE --summary=FILE.json]

#include "fathom/base/files/exists.h"
#include "fathom/base/files/output_file.h"
#include "fathom/base/files/temporary.h"
#include "fathom/base/input_error.h"
#include "fathom/camera/detections_file.h"
#include "fathom/camera/tags_file.h"
#include "fathom/detect/detect_tags.h"
#include "fathom/log/remark.h"
#include "fathom/marker_trajectory/marker_trajectory.h"
#include "fathom/tool/flag_values.h"
#include "fathom/tool/output_flags.h"
#include "fathom/tool/output_folder.h"
#include "fathom/tool/progress.h"
#include "fathom/tool/tool.h"
#include "fathom/tool/track_flags.h"
#include "fathom/tool/track_input.h"
#include "fathom/tool/track_output.h"
#include "fathom/tool/track_overlay.h"
#include "fathom/tool/track_summary.h"
#include "fathom/track/overlay.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <gflags/gflags.h>

DEFINE_string(log,
              "",
              "Log folder with images, a video or detections.csv, and with camera.yaml, "
              "tags.yaml and mount.yaml.");
DEFINE_string(out,
              "",
              "Folder of a new log: detections.csv, pose.csv and the files of --log except "
              "images. Default: write into --log.");
DEFINE_bool(overwrite,
            false,
            "Replace the log in --out, unless it holds images, or the files of an earlier track in "
            "--log.");
DEFINE_string(from,
              "",
              "Start from `images` or from `detections` (detections.csv). Default: detections if "
              "the log holds them.");
DEFINE_string(overlay, "", "Draw what was found into this video (.mp4, .avi) or sheet (.png).");
DEFINE_string(summary, "", "Write an account of every frame and detection to this file (JSON).");
namespace fathom {
namespace {

namespace fs = std::filesystem;

const ToolInfo kInfo = {
    .name = "fathom_track",
    .summary = "Finds the trajectory of a vehicle from the markers that its camera sees.",
    .usage = "--log=LOG [--out=LOG --overlay=FILE --summary=FILE.json]",
    .example =
        "fathom_synthesize --vehicle=data/vehicles/flatfish.yaml "
        "--experiment=data/experiments/film_tour.yaml --film=data/films/tour.yaml --render "
        "--out=tour\n"
        "  fathom_track --log=tour --out=tour_tracked --overlay=sheet.png --summary=track.json",
    .details =
        "Exit code 2: fewer than two frames have a pose. docs/vision.md describes the detection, "
        "docs/marker_trajectory.md the trajectory, docs/file_formats.md the files."};

bool IsGiven(const char* flag) { return !gflags::GetCommandLineFlagInfoOrDie(flag).is_default; }

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

// Throws if there is nothing to draw on: poses need detections alone, an overlay needs images.
void RequireImages(const TrackInput& input) {
  try {
    input.Frames();
  } catch (const InputError& error) {
    throw InputError(
        fmt::format("--overlay={}: is drawn on the images that the detections are of, "
                    "and they cannot be opened. {} Leave out --overlay: the poses do "
                    "without it.",
                    FLAGS_overlay,
                    error.what()));
  }
}

// The log with its detections: those it holds, or those found in its images.
TrackInput InputOf(const fs::path& folder, const MarkerTrajectoryOptions& options) {
  const bool from_detections = StartsFromDetections(folder);
  TrackInput input = ReadTrackInput(folder, !from_detections);
  RequireReference(options, input.rig.map, folder / "tags.yaml");
  RequireOtherThanFrames(input, {{"overlay", FLAGS_overlay}, {"summary", FLAGS_summary}});
  if (from_detections) {
    RequireNoDetectorFlags(folder);
    input.name = (folder / "detections.csv").string();
    input.detections = DetectionsOf(*input.log.detections);
    if (!FLAGS_overlay.empty()) RequireImages(input);
    return input;
  }
  Progress progress("frame");
  const auto frames = input.Frames();
  input.name = frames->name();
  input.images = DetectTags(*frames,
                            input.rig.camera,
                            input.rig.map,
                            DetectorOptionsFromFlags(),
                            [&](int done, int expected) { progress.Show(done, expected); });
  input.detections = input.images->detections;
  return input;
}

std::unique_ptr<OverlayWriter> MakeOverlay(const TrackInput& input, const MarkerTrack& track) {
  constexpr double kUsualRate = 10.0;  // [Hz]
  const auto frames = input.Frames();
  const double rate = frames->mean_rate();
  auto overlay = OpenOverlay(FLAGS_overlay,
                             input.rig.camera.width,
                             input.rig.camera.height,
                             rate > 0.0 ? rate : kUsualRate);
  std::vector<std::string> remarks;
  {
    Progress progress("overlay frame");
    remarks = DrawOverlay(*frames,
                          input.rig.camera,
                          input.images,
                          input.detections,
                          track,
                          overlay.get(),
                          [&](int done, int expected) { progress.Show(done, expected); });
  }
  for (const std::string& remark : remarks) fmt::print(stderr, "{}\n", remark);
  return overlay;
}

void PrintRemarks(std::span<const Remark> remarks) {
  for (const Remark& remark : remarks) fmt::print(stderr, "{}\n", remark.text);
}

// The track as a log in itself.
void WriteNewLog(const fs::path& folder,
                 const TrackInput& input,
                 const MarkerTrack& track,
                 const TrackSummary& summary) {
  CopyLog(input.log, track, folder);
  WriteTrack(folder, track, summary.remarks);
  if (input.images) WriteDetections(folder / "detections.csv", input.detections);
}

// The track beside what the log holds already.
void WriteIntoLog(const fs::path& folder,
                  const TrackInput& input,
                  const MarkerTrack& track,
                  const TrackSummary& summary) {
  if (input.images) WriteDetections(folder / "detections.csv", input.detections);
  WriteTrack(folder, track, summary.remarks);
  fmt::print(stderr,
             "{}: the poses are written into this log. --out makes a log of its own.\n",
             folder.string());
  const fs::path estimated = folder / "tags_estimated.yaml";
  if (track.estimated_ids.empty()) {
    std::error_code error;
    fs::remove(estimated, error);  // of an earlier track
    return;
  }
  WriteFile(estimated, FormatTagsFile(track.map));
  fmt::print(stderr,
             "{}: the estimated positions, on which the poses rest. Tools that use corners read "
             "tags.yaml: replace it by this file, or write a new log (--out).\n",
             estimated.string());
}

int RunTrack() {
  const fs::path folder = RequireFlag("log", FLAGS_log, "a log folder with images");
  RequireOnePath("log", FLAGS_log);
  MarkerTrajectoryOptions options = TrajectoryOptionsFromFlags();
  const fs::path out = WhereToWrite(folder);
  RequireWritable(out);
  const TrackInput input = InputOf(folder, options);
  PrintRemarks(input.log.remarks);
  if (input.images) {
    for (const std::string& problem : input.images->unreadable) fmt::print(stderr, "{}\n", problem);
    options.pose_track.frame_times = input.images->frame_times;
  }
  options.pose_track.name = input.name;
  const CameraRig& rig = input.rig;
  const MarkerTrack track =
      TrackMarkers(input.detections, rig.camera, rig.map, rig.body_from_camera, options);
  constexpr std::size_t kFewestPoses = 2;  // of a pose.csv
  const bool is_usable = track.world_from_body.size() >= kFewestPoses;
  if (is_usable) RequireOneClock(input, track);
  const TrackSummary summary =
      Summarize(input.log.name, input.images, input.detections, rig.camera, rig.map, track);
  PrintRemarks(summary.remarks);

  // All are made before the first takes its name: whatever fails leaves nothing behind.
  std::unique_ptr<OverlayWriter> overlay;
  if (!FLAGS_overlay.empty()) overlay = MakeOverlay(input, track);
  std::optional<Temporary> made;
  if (is_usable && !FLAGS_out.empty()) {
    WriteNewLog(made.emplace(out).path(), input, track, summary);
  }
  if (!FLAGS_summary.empty()) {
    WriteFile(FLAGS_summary, FormatJson(summary, track, input.detections));
  }
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
    WriteIntoLog(out, input, track, summary);
  }
  fmt::print("{:<20}{}\n{}", "log", out.string(), FormatText(summary, track));
  return 0;
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  return fathom::RunTool(argc, argv, fathom::kInfo, fathom::RunTrack);
}
