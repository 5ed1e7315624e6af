// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/track_input.h"

#include "fathom/base/files/exists.h"
#include "fathom/base/files/input_file.h"
#include "fathom/base/input_error.h"
#include "fathom/images/frame_list.h"
#include "fathom/log/log_clocks.h"
#include "fathom/log/read_log.h"

#include <system_error>
#include <vector>

#include <fmt/format.h>

namespace fathom {

namespace fs = std::filesystem;

std::unique_ptr<FrameSource> TrackInput::Frames() const {
  return OpenFrames(
      folder, {log.video, log.video_start}, rig.camera, (folder / "camera.yaml").string());
}

namespace {

// What is missing of what the camera saw, besides its calibration. `video`: of log.yaml.
std::vector<std::string> MissingViews(const fs::path& folder,
                                      const std::string& video,
                                      bool from_images) {
  if (!from_images) return {};
  if (!video.empty() && !Exists(folder / video)) {
    return {fmt::format("{} (the video, as log.yaml's key 'video' says)", video)};
  }
  if (!video.empty() || Exists(folder / "frames.csv")) return {};
  return {"images (frames.csv, or a video that log.yaml's key 'video' names)"};
}

// Throws InputError, naming all that are missing, if log.yaml and more are.
void RequireLogYaml(const fs::path& folder, bool from_images) {
  if (Exists(folder / "log.yaml")) return;
  std::vector<std::string> missing = MissingViews(folder, "", from_images);
  missing.insert(missing.begin(), "log.yaml (name and dof of the log)");
  RequireRigFiles(folder, missing);
}

}  // namespace

TrackInput ReadTrackInput(const fs::path& folder, bool from_images) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    throw InputError(fmt::format("{}: is no folder, expected a log folder.", folder.string()));
  }
  RequireLogYaml(folder, from_images);
  TrackInput input;
  input.folder = folder;
  input.log = ReadLog(folder, {.may_lack_motion = true, .may_lack_command = true});
  std::erase_if(input.log.remarks, [](const Remark& remark) {
    return remark.kind == RemarkKind::kPoses || remark.kind == RemarkKind::kLostMotion;
  });
  RequireRigFiles(folder, MissingViews(folder, input.log.video, from_images));
  input.rig = ReadCameraRig(folder);
  for (const std::string& remark : input.rig.remarks) {
    input.log.remarks.push_back({RemarkKind::kGeneral, remark});
  }
  return input;
}

void RequireOtherThanFrames(const TrackInput& input,
                            const std::vector<std::pair<std::string, std::string>>& outputs) {
  std::error_code error;
  const Log& log = input.log;
  std::vector<std::string> files = {log.video};
  const fs::path list = input.folder / "frames.csv";
  if (log.video.empty() && fs::exists(list, error)) {
    for (const ListedFrame& frame : ParseFrameList(list.string(), ReadFile(list)).frames) {
      files.push_back(frame.file);
    }
  }
  for (const auto& [flag, output] : outputs) {
    if (output.empty() || !fs::exists(output, error)) continue;
    for (const std::string& file : files) {
      if (file.empty() || !fs::equivalent(output, input.folder / file, error)) continue;
      throw InputError(
          fmt::format("--{}={}: is what --log={} was filmed as, expected another file.",
                      flag,
                      output,
                      input.folder.string()));
    }
  }
}

void RequireOneClock(const TrackInput& input, const MarkerTrack& track) {
  if (!input.images || !input.log.command) return;
  CsvTable command, poses;
  command.name = (input.folder / "command.csv").string();
  command.stream = *input.log.command;
  poses.name = input.name;
  for (const StampedPose& pose : track.world_from_body) poses.stream.time.push_back(pose.time);
  RefuseDisjointClocks(command, poses);
}

}  // namespace fathom
