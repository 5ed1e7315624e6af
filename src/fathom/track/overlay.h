// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/detection.h"
#include "fathom/detect/detection_filter.h"
#include "fathom/images/gray_image.h"
#include "fathom/track/detection_screen.h"

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// One frame with what was made of it, for a person to check.
struct OverlayFrame {
  const GrayImage* image = nullptr;
  std::string caption;                // ASCII
  std::vector<Detection> detections;  // in use: outlined in green, the first corner as a dot

  // Outlined in red, with the reason.
  std::vector<UnusedSighting> unused;
  struct Rejected {
    Detection detection;
    Rejection reason = Rejection::kOutlier;
  };
  std::vector<Rejected> rejected;

  // Where the estimated pose puts the corners: orange crosses.
  std::vector<std::array<Eigen::Vector2d, 4>> predicted;
};

// Draws overlay frames into a video, or some of them side by side on one picture (a contact sheet).
// The file takes its name once it is complete; a writer that is not finished leaves nothing behind.
class OverlayWriter {
 public:
  virtual ~OverlayWriter() = default;

  virtual void Add(const OverlayFrame& frame) = 0;

  // Throws InputError, naming the file, if it cannot be written in full, or no frame was added.
  virtual void Finish() = 0;

  // True for the frames that are to be added: all of a video; 12 of a contact sheet, evenly over
  // the record, or the first ones of more than there should be.
  virtual bool Wants(int frame_index, int num_frames) const = 0;
};

// Throws InputError for a path with another ending than those of OpenOverlay.
void RequireOverlayEnding(const std::filesystem::path& path);

// By the ending of the path: .mp4 or .avi for a video, .png for a contact sheet. `rate` is that of
// the frames [Hz]. Throws InputError for another ending or a video that cannot be opened.
std::unique_ptr<OverlayWriter> OpenOverlay(const std::filesystem::path& path,
                                           int width,
                                           int height,
                                           double rate);

}  // namespace fathom
