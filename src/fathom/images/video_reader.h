// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/images/gray_image.h"

#include <filesystem>
#include <memory>

namespace fathom {

// The frames of a video file, one after the other, in grey, by FFmpeg, as the sensor sees them: how
// the container says that they are to be turned is ignored, since a calibration is of the sensor's
// pixels.
//
// Each packet of the file is taken for one frame, and frames are numbered by the stamps of their
// packets: one that cannot be decoded is missing, and those behind it keep their numbers. Damage
// that the decoder conceals is not seen.
class VideoReader {
 public:
  // Reads through the file once for the stamps. Throws InputError if it is not there, cannot be
  // opened as a video, or holds no frame.
  explicit VideoReader(const std::filesystem::path& path);
  ~VideoReader();
  VideoReader(VideoReader&&) noexcept;
  VideoReader& operator=(VideoReader&&) noexcept;

  // Frames that are in the file, whether or not they can be decoded.
  int num_frames() const;

  // Those and the ones that are not, where the header counts them all. No less than num_frames().
  int num_announced() const;

  // As the header has it [s]; 0 where it does not say, or counts the frames instead.
  double duration() const;

  // Mean over the file, by its stamps [Hz]; NaN where these do not say.
  double mean_rate() const;

  // Decodes the next frame that can be; false at the end.
  bool Next(GrayImage* image);

  // Of the frame read last, counted from 0.
  int index() const;

  // When the frame read last is shown, since the start of the video [s].
  double time() const;

 private:
  struct Implementation;

  std::unique_ptr<Implementation> implementation_;
};

}  // namespace fathom
