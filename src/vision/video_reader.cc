// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vision/video_reader.h"

#include "fathom/base/input_error.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <system_error>

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

namespace fathom {
namespace {

void RequireFile(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    throw InputError(path.string() + ": there is no such file. Check the path.");
  }
  if (std::filesystem::is_directory(path, error)) {
    throw InputError(path.string() + ": is a folder, expected a file.");
  }
}

}  // namespace

struct VideoReader::Implementation {
  cv::VideoCapture capture;
  cv::Mat colour;
  cv::Mat gray;
  double time = 0.0;  // [s]
};

VideoReader::VideoReader(const std::filesystem::path& path)
    : implementation_(std::make_unique<Implementation>()) {
  RequireFile(path);
  // FFmpeg's own words on stderr, which name no file; ours follow from what it returns.
  setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);
  bool is_open = false;
  try {
    is_open = implementation_->capture.open(path.string(), cv::CAP_FFMPEG);
    // Sensor pixels, whatever way up the container wants them shown.
    if (is_open) implementation_->capture.set(cv::CAP_PROP_ORIENTATION_AUTO, 0);
  } catch (const cv::Exception&) {
  }
  if (!is_open) {
    throw InputError(path.string() +
                     ": cannot be opened as a video. It is damaged, cut off (an MP4 has its index "
                     "at the end), or of a format that FFmpeg does not know.");
  }
}

VideoReader::~VideoReader() = default;
VideoReader::VideoReader(VideoReader&&) noexcept = default;
VideoReader& VideoReader::operator=(VideoReader&&) noexcept = default;

int VideoReader::num_announced() const {
  const double count = implementation_->capture.get(cv::CAP_PROP_FRAME_COUNT);
  return count >= 1.0 && count < 1e9 ? static_cast<int>(std::lround(count)) : 0;
}

bool VideoReader::Next(GrayImage* image) {
  Implementation& it = *implementation_;
  try {
    if (!it.capture.read(it.colour) || it.colour.empty()) return false;
    it.time = it.capture.get(cv::CAP_PROP_POS_MSEC) / 1000.0;
    if (it.colour.channels() == 1) {
      it.gray = it.colour;
    } else {
      cv::cvtColor(it.colour, it.gray, cv::COLOR_BGR2GRAY);
    }
  } catch (const cv::Exception&) {
    return false;
  }
  *image = GrayImage(it.gray.cols, it.gray.rows);
  for (int v = 0; v < image->height; ++v) {
    std::copy_n(it.gray.ptr<std::uint8_t>(v), image->width, &image->At(0, v));
  }
  return true;
}

double VideoReader::time() const { return implementation_->time; }

}  // namespace fathom
