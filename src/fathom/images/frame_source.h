// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_model.h"
#include "fathom/images/gray_image.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace fathom {

struct ImageFrame {
  double time = 0.0;  // log time [s]
  std::string name;   // as in messages: "frames/0012.png", "camera.mp4, frame 12"
  GrayImage image;
};

// The frames of a camera log in the order of their stamps, whether images or a video.
//
//   const auto frames = OpenFrames(folder, {log.video, log.video_start}, camera, camera_file);
//   for (ImageFrame frame; frames->Next(&frame);) { ... }
//   frames->unreadable();  // what was passed over
class FrameSource {
 public:
  virtual ~FrameSource() = default;

  // The file that lists the frames, or the video.
  virtual std::string name() const = 0;

  // Frames there should be: those listed, or those that the video holds or announces.
  virtual int num_expected() const = 0;

  // Mean over the record [Hz]; NaN where it is not known.
  virtual double mean_rate() const = 0;

  // The next frame that can be read; false at the end. Throws InputError where a frame has another
  // size than the camera's calibration, or the stamps of a video do not rise.
  virtual bool Next(ImageFrame* frame) = 0;

  // Frames that were expected and could not be read so far.
  int num_unreadable() const { return num_unreadable_; }

  // What was the matter with them, a sentence for each image or each gap of a video.
  const std::vector<std::string>& unreadable() const { return unreadable_; }

  // What is beside the frames and not read, a sentence each.
  const std::vector<std::string>& remarks() const { return remarks_; }

 protected:
  int num_unreadable_ = 0;
  std::vector<std::string> unreadable_;
  std::vector<std::string> remarks_;
};

// A video of a log folder, as log.yaml names it.
struct VideoOfLog {
  std::string file;    // from the folder on; empty: there is none
  double start = 0.0;  // when its own clock is at 0 [s], in the log's time
};

// Opens the frames of a log folder: `video`, stamped by frame_times.csv where there is one and by
// the container else, or the images of frames.csv. `camera_file` names the calibration in messages.
// Throws InputError if there are neither, or both, they cannot be opened, a video holds more frames
// than there are stamps, or has a start beside frame_times.csv.
std::unique_ptr<FrameSource> OpenFrames(const std::filesystem::path& folder,
                                        const VideoOfLog& video,
                                        const CameraModel& camera,
                                        const std::string& camera_file);

}  // namespace fathom
