// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/track/detection_screen.h"

#include "fathom/base/input_error.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include <fmt/format.h>

namespace fathom {
namespace {

using Corners = std::array<Eigen::Vector2d, 4>;

// Twice the signed area; negative for corners that run anticlockwise on the screen (v down), as
// those of an upright tag do: bottom-left, bottom-right, top-right, top-left.
double TwiceTheArea(const Corners& c) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector2d& a = c[i];
    const Eigen::Vector2d& b = c[(i + 1) % 4];
    sum += a.x() * b.y() - a.y() * b.x();
  }
  return sum;
}

// Every turn to the left on the screen; a view of a square from its front.
bool IsConvexFromTheFront(const Corners& c) {
  constexpr double kFlattest = 0.5;  // of a turn's two sides: twice their triangle [px^2]
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector2d in = c[(i + 1) % 4] - c[i];
    const Eigen::Vector2d out = c[(i + 2) % 4] - c[(i + 1) % 4];
    if (!(in.x() * out.y() - in.y() * out.x() < -kFlattest)) return false;
  }
  return true;
}

// A detector's corner may lie on the rim of the image, and a little beyond by its refinement.
bool IsOnTheImage(const CameraModel& camera, double largest_angle, const Corners& corners) {
  constexpr double kBeyond = 2.0;  // [px]
  return std::all_of(corners.begin(), corners.end(), [&](const Eigen::Vector2d& corner) {
    const Eigen::Vector2d nearest(std::clamp(corner.x(), -0.5, camera.width - 0.5),
                                  std::clamp(corner.y(), -0.5, camera.height - 0.5));
    return (corner - nearest).norm() <= kBeyond && RayOf(camera, corner, largest_angle).has_value();
  });
}

void RefuseWhatIsNoRecord(std::span<const Detection> detections, std::string_view name) {
  for (std::size_t i = 0; i < detections.size(); ++i) {
    const Detection& detection = detections[i];
    const bool is_finite = std::all_of(detection.corners.begin(),
                                       detection.corners.end(),
                                       [](const auto& corner) { return corner.allFinite(); });
    if (!is_finite) {
      throw InputError(fmt::format("{}: tag {} at t = {} has a corner that is not finite.",
                                   name,
                                   detection.tag_id,
                                   detection.time));
    }
    if (i > 0 && !(detection.time >= detections[i - 1].time)) {
      throw InputError(fmt::format("{}: t goes back from {} to {}, expected rising stamps.",
                                   name,
                                   detections[i - 1].time,
                                   detection.time));
    }
  }
}

std::vector<ScreenedFrame> FramesOf(std::span<const Detection> detections,
                                    std::span<const double> frame_times,
                                    std::string_view name) {
  std::vector<ScreenedFrame> frames;
  for (const double time : frame_times) {
    if (!frames.empty() && !(time > frames.back().time)) {
      throw InputError(
          fmt::format("{}: t of the frames goes from {} to {}, expected rising stamps.",
                      name,
                      frames.back().time,
                      time));
    }
    frames.push_back({.time = time, .detections = {}});
  }
  std::size_t at = 0;
  for (std::size_t i = 0; i < detections.size(); ++i) {
    const double time = detections[i].time;
    if (frame_times.empty() && (frames.empty() || frames.back().time != time)) {
      frames.push_back({.time = time, .detections = {}});
      at = frames.size() - 1;
    }
    while (at < frames.size() && frames[at].time < time) ++at;
    if (at == frames.size() || frames[at].time != time) {
      throw InputError(fmt::format(
          "{}: t = {} is the stamp of no frame, expected those of the frames.", name, time));
    }
    frames[at].detections.push_back(static_cast<int>(i));
  }
  return frames;
}

// Which of the detections, if any, cannot count whatever the pose.
std::optional<Rejection> RejectionOf(const Detection& detection,
                                     int num_of_this_id,
                                     const CameraModel& camera,
                                     double largest_angle,
                                     const MarkerMap& map) {
  if (map.Find(detection.tag_id) == nullptr) return Rejection::kUnknownId;
  if (num_of_this_id > 1) return Rejection::kRepeatedId;
  // Off the image first: what lies far from it has no order, or an area beyond all numbers.
  if (!IsOnTheImage(camera, largest_angle, detection.corners)) return Rejection::kOffImage;
  if (TwiceTheArea(detection.corners) > 0.0) return Rejection::kMirrored;
  if (!IsConvexFromTheFront(detection.corners)) return Rejection::kNoSquare;
  return std::nullopt;
}

void RefuseIfMost(const std::array<std::size_t, kNumRejections>& counts,
                  std::size_t num_detections,
                  const CameraModel& camera,
                  std::string_view name) {
  const auto is_most = [&](Rejection reason) {
    return 2 * counts[static_cast<std::size_t>(reason)] > num_detections;
  };
  const auto count = [&](Rejection reason) { return counts[static_cast<std::size_t>(reason)]; };
  if (is_most(Rejection::kMirrored)) {
    throw InputError(fmt::format(
        "{}: the corners of {} of {} run clockwise in the image, expected bottom-left, "
        "bottom-right, top-right, top-left of the upright tag. Are the images mirrored, or the "
        "corners in another order (OpenCV's aruco starts at the top-left)?",
        name,
        count(Rejection::kMirrored),
        num_detections));
  }
  if (is_most(Rejection::kOffImage)) {
    throw InputError(fmt::format(
        "{}: {} of {} lie outside the camera's image of {} x {} pixels or its lens' field. "
        "Is this the calibration of another camera or resolution?",
        name,
        count(Rejection::kOffImage),
        num_detections,
        camera.width,
        camera.height));
  }
}

}  // namespace

std::string_view Name(Rejection rejection) {
  constexpr std::array<std::string_view, kNumRejections> kNames = {"unknown id",
                                                                   "not surveyed",
                                                                   "repeated id",
                                                                   "mirrored",
                                                                   "off the image",
                                                                   "no square",
                                                                   "outlier",
                                                                   "beyond 90 degrees"};
  return kNames[static_cast<std::size_t>(rejection)];
}

ScreenedDetections ScreenDetections(std::span<const Detection> detections,
                                    const CameraModel& camera,
                                    const MarkerMap& map,
                                    std::span<const double> frame_times,
                                    std::string_view name) {
  RefuseWhatIsNoRecord(detections, name);
  ScreenedDetections screened;
  screened.frames = FramesOf(detections, frame_times, name);
  const double largest_angle = LargestAngle(camera);
  std::array<std::size_t, kNumRejections> counts = {};
  for (ScreenedFrame& frame : screened.frames) {
    const std::vector<int> all = frame.detections;
    frame.detections.clear();
    for (const int i : all) {
      const auto same_id = [&](int j) { return detections[j].tag_id == detections[i].tag_id; };
      const auto num_of_this_id = std::count_if(all.begin(), all.end(), same_id);
      const auto rejection =
          RejectionOf(detections[i], static_cast<int>(num_of_this_id), camera, largest_angle, map);
      if (!rejection) {
        frame.detections.push_back(i);
        continue;
      }
      ++counts[static_cast<std::size_t>(*rejection)];
      screened.rejected.push_back({.index = i, .reason = *rejection});
    }
  }
  RefuseIfMost(counts, detections.size(), camera, name);
  return screened;
}

}  // namespace fathom
