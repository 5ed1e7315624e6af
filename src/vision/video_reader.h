// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vision/gray_image.h"

#include <filesystem>
#include <memory>

namespace fathom {

// The frames of a video file, one after the other, in grey.
class VideoReader {
 public:
  // Throws InputError if the file is not there or cannot be opened as a video.
  explicit VideoReader(const std::filesystem::path& path);
  ~VideoReader();
  VideoReader(VideoReader&&) noexcept;
  VideoReader& operator=(VideoReader&&) noexcept;

  // Frames that the container announces; 0 where it does not say.
  int num_announced() const;

  // Decodes the next frame; false at the end, which for a file that is cut off comes early.
  bool Next(GrayImage* image);

  // When the frame read last is shown, since the start of the video [s].
  double time() const;

 private:
  struct Implementation;

  std::unique_ptr<Implementation> implementation_;
};

}  // namespace fathom
