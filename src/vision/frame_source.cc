// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vision/frame_source.h"

#include "fathom/base/input_error.h"
#include "fathom/base/input_file.h"
#include "fathom/vision/camera_file.h"
#include "fathom/vision/frame_list.h"
#include "fathom/vision/image_file.h"
#include "fathom/vision/video_reader.h"

#include <cstddef>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

bool Exists(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::exists(path, error);
}

// What frames are checked against.
struct ExpectedSize {
  CameraModel camera;
  std::string camera_file;

  void Require(const std::string& frame, const GrayImage& image) const {
    RequireFrameSize(camera, camera_file, frame, image.width, image.height);
  }
};

class ListedImages : public FrameSource {
 public:
  ListedImages(std::filesystem::path folder, ExpectedSize size)
      : folder_(std::move(folder)), size_(std::move(size)) {
    const std::filesystem::path list = folder_ / "frames.csv";
    list_name_ = list.string();
    frames_ = ParseFrameList(list_name_, ReadFile(list));
  }

  int num_expected() const override { return static_cast<int>(frames_.size()); }

  bool Next(ImageFrame* frame) override {
    while (next_ < frames_.size()) {
      const ListedFrame& listed = frames_[next_++];
      try {
        frame->image = ReadImage(folder_ / listed.file);
      } catch (const InputError& error) {
        ++num_unreadable_;
        unreadable_.push_back(fmt::format("{}:{}: {}", list_name_, listed.line, error.what()));
        continue;
      }
      frame->time = listed.time;
      frame->name = (folder_ / listed.file).string();
      size_.Require(frame->name, frame->image);
      return true;
    }
    return false;
  }

 private:
  std::filesystem::path folder_;
  ExpectedSize size_;
  std::string list_name_;
  std::vector<ListedFrame> frames_;
  std::size_t next_ = 0;
};

class VideoFrames : public FrameSource {
 public:
  VideoFrames(const std::filesystem::path& folder, const std::string& video, ExpectedSize size)
      : size_(std::move(size)),
        name_((folder / video).string()),
        times_name_((folder / "frame_times.csv").string()),
        reader_(folder / video) {
    if (Exists(times_name_)) times_ = ParseFrameTimes(times_name_, ReadFile(times_name_));
  }

  int num_expected() const override {
    return times_ ? static_cast<int>(times_->size()) : reader_.num_announced();
  }

  bool Next(ImageFrame* frame) override {
    if (is_over_) return false;
    if (!reader_.Next(&frame->image)) {
      is_over_ = true;
      CountTheMissing();
      return false;
    }
    if (times_ && next_ >= times_->size()) {
      throw InputError(
          fmt::format("{}: frame {} has no stamp: {} ends at frame {}. Expected a row "
                      "for each frame.",
                      name_,
                      next_,
                      times_name_,
                      next_ - 1));
    }
    frame->name = fmt::format("{}, frame {}", name_, next_);
    frame->time = times_ ? (*times_)[next_] : reader_.time();
    size_.Require(frame->name, frame->image);
    RequireRisingTime(*frame);
    ++next_;
    last_time_ = frame->time;
    return true;
  }

 private:
  void CountTheMissing() {
    const int num_read = static_cast<int>(next_);
    if (num_read >= num_expected()) return;
    num_unreadable_ = num_expected() - num_read;
    unreadable_.push_back(
        fmt::format("{}: ends after {} frames, expected {} as {}. The video is cut off or damaged.",
                    name_,
                    num_read,
                    num_expected(),
                    times_ ? times_name_ + " lists" : std::string("its header says")));
  }

  void RequireRisingTime(const ImageFrame& frame) const {
    if (!last_time_ || frame.time > *last_time_) return;
    throw InputError(
        fmt::format("{}: the container stamps it {} s, the frame before {} s; expected rising "
                    "stamps. Write them to {}.",
                    frame.name,
                    frame.time,
                    *last_time_,
                    times_name_));
  }

  ExpectedSize size_;
  std::string name_;
  std::string times_name_;
  VideoReader reader_;
  std::optional<std::vector<double>> times_;
  std::size_t next_ = 0;
  std::optional<double> last_time_;
  bool is_over_ = false;
};

}  // namespace

std::unique_ptr<FrameSource> OpenFrames(const std::filesystem::path& folder,
                                        const std::string& video,
                                        const CameraModel& camera,
                                        const std::string& camera_file) {
  const bool has_list = Exists(folder / "frames.csv");
  if (has_list && !video.empty()) {
    throw InputError(
        fmt::format("{}: holds frames.csv, and log.yaml names the video {}; expected one of them. "
                    "Remove the other.",
                    folder.string(),
                    video));
  }
  ExpectedSize size{camera, camera_file};
  if (!video.empty()) return std::make_unique<VideoFrames>(folder, video, std::move(size));
  if (has_list) return std::make_unique<ListedImages>(folder, std::move(size));
  throw InputError(
      fmt::format("{}: holds no images: no frames.csv, and log.yaml names no video. See "
                  "docs/file_formats.md.",
                  folder.string()));
}

}  // namespace fathom
