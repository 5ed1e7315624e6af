// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/images/frame_source.h"

#include "fathom/base/files/exists.h"
#include "fathom/base/files/input_file.h"
#include "fathom/base/input_error.h"
#include "fathom/camera/camera_file.h"
#include "fathom/images/frame_list.h"
#include "fathom/images/image_file.h"
#include "fathom/images/video_reader.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

double MeanRate(double first, double last, std::size_t num) {
  if (!(last > first)) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(num - 1) / (last - first);
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
    FrameList read = ParseFrameList(list_name_, ReadFile(list));
    frames_ = std::move(read.frames);
    if (!read.remark.empty()) remarks_.push_back(read.remark);
    const std::filesystem::path times = folder_ / "frame_times.csv";
    if (Exists(times)) {
      remarks_.push_back(fmt::format(
          "{}: is not read, because it is for a video and log.yaml names none.", times.string()));
    }
  }

  std::string name() const override { return list_name_; }

  int num_expected() const override { return static_cast<int>(frames_.size()); }

  double mean_rate() const override {
    return MeanRate(frames_.front().time, frames_.back().time, frames_.size());
  }

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

// "frame 7", "frames 7 to 9".
std::string Range(int first, int last) {
  if (first == last) return fmt::format("frame {}", first);
  return fmt::format("frames {} to {}", first, last);
}

class VideoFrames : public FrameSource {
 public:
  VideoFrames(const std::filesystem::path& folder, const VideoOfLog& video, ExpectedSize size)
      : size_(std::move(size)),
        name_((folder / video.file).string()),
        times_name_((folder / "frame_times.csv").string()),
        reader_(folder / video.file),
        start_(video.start) {
    if (!Exists(times_name_)) return;
    if (start_ != 0.0) {
      throw InputError(
          fmt::format("{}: stands beside log.yaml's video_start, expected one of them "
                      "to say when the frames were taken.",
                      times_name_));
    }
    FrameTimes read = ParseFrameTimes(times_name_, ReadFile(times_name_));
    if (!read.remark.empty()) remarks_.push_back(read.remark);
    times_ = std::move(read.times);
    RequireStamps(reader_.num_frames());
  }

  std::string name() const override { return name_; }

  int num_expected() const override {
    return times_ ? static_cast<int>(times_->size()) : reader_.num_announced();
  }

  double mean_rate() const override {
    return times_ ? MeanRate(times_->front(), times_->back(), times_->size()) : reader_.mean_rate();
  }

  bool Next(ImageFrame* frame) override {
    if (is_over_) return false;
    if (!reader_.Next(&frame->image)) {
      is_over_ = true;
      CountUpTo(reader_.num_frames());
      CountWhatTheFileLacks();
      return false;
    }
    const int index = reader_.index();
    CountUpTo(index);
    next_ = index + 1;
    RequireStamps(next_);
    frame->name = fmt::format("{}, frame {}", name_, index);
    frame->time = times_ ? (*times_)[index] : start_ + reader_.time();
    size_.Require(frame->name, frame->image);
    RequireRisingTime(*frame);
    last_time_ = frame->time;
    return true;
  }

 private:
  void RequireStamps(int num_frames) const {
    if (!times_ || num_frames <= static_cast<int>(times_->size())) return;
    throw InputError(
        fmt::format("{}: frame {} has no stamp: {} ends at frame {}. Expected a row for each of "
                    "the {} frames.",
                    name_,
                    times_->size(),
                    times_name_,
                    times_->size() - 1,
                    num_frames));
  }

  // The frames from the next one to before this one, which are in the file and gave no image.
  void CountUpTo(int index) {
    if (index <= next_) return;
    num_unreadable_ += index - next_;
    unreadable_.push_back(fmt::format(
        "{}: {} cannot be decoded. The video is damaged there.", name_, Range(next_, index - 1)));
  }

  void CountWhatTheFileLacks() {
    const int num_frames = reader_.num_frames();
    if (num_frames < num_expected()) {
      num_unreadable_ += num_expected() - num_frames;
      unreadable_.push_back(fmt::format(
          "{}: ends after {} frames, expected {} as {}. The video is cut off or damaged.",
          name_,
          num_frames,
          num_expected(),
          times_ ? times_name_ + " lists" : std::string("its header says")));
      return;
    }
    // Containers that count no frames (MKV) may still say how long they are.
    constexpr double kOfNoAccount = 1.0;  // [s]
    const double end = last_time_.value_or(0.0);
    if (!times_ && reader_.duration() > end + kOfNoAccount) {
      unreadable_.push_back(
          fmt::format("{}: ends at {:.1f} s, expected about {:.1f} s as its header says. The video "
                      "may be cut off; how many frames are missing is not known.",
                      name_,
                      end,
                      reader_.duration()));
    }
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
  double start_;
  std::optional<std::vector<double>> times_;
  int next_ = 0;
  std::optional<double> last_time_;
  bool is_over_ = false;
};

}  // namespace

std::unique_ptr<FrameSource> OpenFrames(const std::filesystem::path& folder,
                                        const VideoOfLog& video,
                                        const CameraModel& camera,
                                        const std::string& camera_file) {
  const bool has_list = Exists(folder / "frames.csv");
  if (has_list && !video.file.empty()) {
    throw InputError(
        fmt::format("{}: holds frames.csv, and log.yaml names the video {}; expected one of them. "
                    "Remove the other.",
                    folder.string(),
                    video.file));
  }
  ExpectedSize size{camera, camera_file};
  if (!video.file.empty()) return std::make_unique<VideoFrames>(folder, video, std::move(size));
  if (has_list) return std::make_unique<ListedImages>(folder, std::move(size));
  throw InputError(
      fmt::format("{}: holds no images: no frames.csv, and log.yaml names no video. See "
                  "docs/file_formats.md.",
                  folder.string()));
}

}  // namespace fathom
