// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/track/overlay.h"

#include "fathom/base/files/output_file.h"
#include "fathom/base/files/temporary.h"
#include "fathom/base/input_error.h"
#include "fathom/images/video_reader.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

namespace fathom {
namespace {

const cv::Scalar kGreen(80, 220, 60);
const cv::Scalar kRed(60, 60, 255);
const cv::Scalar kOrange(0, 165, 255);
const cv::Scalar kWhite(255, 255, 255);

// OpenCV draws with 4 binary places where it is told so.
constexpr int kShift = 4;

cv::Point PlaceOf(const Eigen::Vector2d& pixel, double scale) {
  // The centre of the first pixel of a picture made smaller by `scale` is not that of the large
  // one.
  const Eigen::Vector2d place = scale * (pixel.array() + 0.5).matrix().eval();
  return {static_cast<int>(std::lround((place.x() - 0.5) * (1 << kShift))),
          static_cast<int>(std::lround((place.y() - 0.5) * (1 << kShift)))};
}

// Writes one line with its lower left corner at `at`, moved left or made smaller where it would
// leave the picture.
void Write(cv::Mat* picture,
           const std::string& text,
           cv::Point at,
           double size,
           const cv::Scalar& colour) {
  constexpr int kMargin = 5;
  const auto width = [&] {
    return cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, size, 1, nullptr).width;
  };
  const int room = picture->cols - 2 * kMargin;
  if (width() > room) size *= static_cast<double>(room) / width();
  at.x = std::max(kMargin, std::min(at.x, picture->cols - kMargin - width()));
  cv::putText(*picture, text, at, cv::FONT_HERSHEY_SIMPLEX, size, colour, 1, cv::LINE_AA);
}

void Outline(cv::Mat* picture,
             const std::array<Eigen::Vector2d, 4>& corners,
             const std::string& label,
             const cv::Scalar& colour,
             double scale) {
  for (int i = 0; i < 4; ++i) {
    cv::line(*picture,
             PlaceOf(corners[i], scale),
             PlaceOf(corners[(i + 1) % 4], scale),
             colour,
             1,
             cv::LINE_AA,
             kShift);
  }
  cv::circle(
      *picture, PlaceOf(corners[0], scale), 3 << kShift, colour, cv::FILLED, cv::LINE_AA, kShift);
  const cv::Point at = PlaceOf(corners[2], scale);
  Write(picture, label, {(at.x >> kShift) + 4, (at.y >> kShift) - 3}, 0.45, colour);
}

void Cross(cv::Mat* picture, const Eigen::Vector2d& pixel, double scale) {
  constexpr int kArm = 5 << kShift;
  const cv::Point at = PlaceOf(pixel, scale);
  for (const cv::Point& arm : {cv::Point(kArm, kArm), cv::Point(kArm, -kArm)}) {
    cv::line(*picture, at - arm, at + arm, kOrange, 1, cv::LINE_AA, kShift);
  }
}

cv::Mat Draw(const OverlayFrame& frame, double scale) {
  const GrayImage& image = *frame.image;
  const cv::Mat gray(
      image.height, image.width, CV_8U, const_cast<std::uint8_t*>(image.pixels.data()));
  cv::Mat picture;
  cv::cvtColor(gray, picture, cv::COLOR_GRAY2BGR);
  if (scale != 1.0) cv::resize(picture, picture, {}, scale, scale, cv::INTER_AREA);
  for (const UnusedSighting& it : frame.unused) {
    Outline(&picture,
            it.sighting.corners,
            fmt::format("{} {}", it.sighting.tag_id, Describe(it.fault)),
            kRed,
            scale);
  }
  for (const OverlayFrame::Rejected& it : frame.rejected) {
    Outline(&picture,
            it.detection.corners,
            fmt::format("{} {}", it.detection.tag_id, Name(it.reason)),
            kRed,
            scale);
  }
  for (const Detection& detection : frame.detections) {
    Outline(&picture, detection.corners, std::to_string(detection.tag_id), kGreen, scale);
  }
  for (const auto& corners : frame.predicted) {
    for (const Eigen::Vector2d& corner : corners) Cross(&picture, corner, scale);
  }
  const int bar = 18;
  cv::rectangle(picture, {0, 0, picture.cols, bar}, {0, 0, 0}, cv::FILLED);
  Write(&picture, frame.caption, {5, 13}, 0.42, kWhite);
  return picture;
}

[[noreturn]] void RefuseNothing(const std::filesystem::path& path) {
  throw InputError(path.string() +
                   ": cannot be made of no frame, expected one at least that can be read.");
}

int NumFramesIn(const std::filesystem::path& video) {
  try {
    return VideoReader(video).num_frames();
  } catch (const InputError&) {
    return 0;
  }
}

class ContactSheet : public OverlayWriter {
 public:
  ContactSheet(std::filesystem::path path, int width)
      : path_(std::move(path)), scale_(std::min(1.0, 420.0 / width)) {}

  void Add(const OverlayFrame& frame) override { pictures_.push_back(Draw(frame, scale_)); }

  void Finish() override {
    if (pictures_.empty()) RefuseNothing(path_);
    constexpr int kColumns = 3;
    std::vector<cv::Mat> rows;
    for (std::size_t i = 0; i < pictures_.size(); i += kColumns) {
      std::vector<cv::Mat> row(pictures_.begin() + i,
                               pictures_.begin() + std::min(i + kColumns, pictures_.size()));
      while (row.size() < kColumns) row.push_back(cv::Mat::zeros(row[0].size(), row[0].type()));
      rows.emplace_back();
      cv::hconcat(row, rows.back());
    }
    cv::Mat sheet;
    cv::vconcat(rows, sheet);
    std::vector<std::uint8_t> bytes;
    cv::imencode(".png", sheet, bytes, {cv::IMWRITE_PNG_COMPRESSION, 9});
    WriteFile(path_, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  }

  bool Wants(int frame_index, int num_frames) const override {
    constexpr int kMost = 12;
    if (num_frames <= kMost) return frame_index < kMost;
    const auto nth = [&](std::int64_t i) { return i * (num_frames - 1) / (kMost - 1); };
    for (int i = 0; i < kMost; ++i) {
      if (nth(i) == frame_index) return true;
    }
    return false;
  }

 private:
  std::filesystem::path path_;
  double scale_;
  std::vector<cv::Mat> pictures_;
};

class OverlayVideo : public OverlayWriter {
 public:
  OverlayVideo(std::filesystem::path path, int width, int height, double rate)
      : path_(std::move(path)), temporary_(path_) {
    // FFmpeg's own words on stderr, which name no file.
    setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);
    std::error_code error;
    if (path_.has_parent_path()) std::filesystem::create_directories(path_.parent_path(), error);
    const int code = path_.extension() == ".avi" ? cv::VideoWriter::fourcc('M', 'J', 'P', 'G')
                                                 : cv::VideoWriter::fourcc('m', 'p', '4', 'v');
    // Codecs want even sides.
    size_ = {width + width % 2, height + height % 2};
    if (!writer_.open(temporary_.path().string(), cv::CAP_FFMPEG, code, rate, size_, true)) {
      throw InputError(path_.string() + ": cannot write this video.");
    }
  }

  void Add(const OverlayFrame& frame) override {
    cv::Mat picture = Draw(frame, 1.0);
    cv::copyMakeBorder(picture,
                       picture,
                       0,
                       size_.height - picture.rows,
                       0,
                       size_.width - picture.cols,
                       cv::BORDER_REPLICATE);
    writer_.write(picture);
    ++num_frames_;
  }

  void Finish() override {
    if (num_frames_ == 0) RefuseNothing(path_);
    // The writer says nothing of what it could not write.
    writer_.release();
    if (const int num_written = NumFramesIn(temporary_.path()); num_written != num_frames_) {
      throw InputError(fmt::format(
          "{}: cannot write this video: {} of its {} frames are in the file. Is the disk "
          "full?",
          path_.string(),
          num_written,
          num_frames_));
    }
    temporary_.TakePlace();
  }

  bool Wants(int, int) const override { return true; }

 private:
  std::filesystem::path path_;
  Temporary temporary_;
  cv::Size size_;
  cv::VideoWriter writer_;
  int num_frames_ = 0;
};

}  // namespace

void RequireOverlayEnding(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  if (ending == ".png" || ending == ".mp4" || ending == ".avi") return;
  throw InputError(path.string() +
                   ": expected a path that ends in .mp4 or .avi for a video, or in .png for a "
                   "contact sheet.");
}

std::unique_ptr<OverlayWriter> OpenOverlay(const std::filesystem::path& path,
                                           int width,
                                           int height,
                                           double rate) {
  RequireOverlayEnding(path);
  if (path.extension() == ".png") return std::make_unique<ContactSheet>(path, width);
  return std::make_unique<OverlayVideo>(path, width, height, rate);
}

}  // namespace fathom
