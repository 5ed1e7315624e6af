// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/track/pose_track.h"

#include "fathom/base/median.h"
#include "fathom/base/plural.h"
#include "fathom/track/pose_choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// SolveSquare of each detection that may count; none for the others.
std::vector<std::vector<Pose>> SquaresOf(std::span<const Detection> detections,
                                         const std::vector<ScreenedFrame>& frames,
                                         const CameraModel& camera,
                                         const MarkerMap& map) {
  std::vector<std::vector<Pose>> squares(detections.size());
  for (const ScreenedFrame& frame : frames) {
    for (const int i : frame.detections) {
      const double size = map.Find(detections[i].tag_id)->size;
      squares[i] = SolveSquare(camera, size, detections[i].corners);
    }
  }
  return squares;
}

std::vector<FrameCandidates> CandidatesOf(std::span<const Detection> detections,
                                          const std::vector<std::vector<Pose>>& squares,
                                          const std::vector<ScreenedFrame>& frames,
                                          const CameraModel& camera,
                                          const MarkerMap& map,
                                          const ViewPoseOptions& options) {
  std::vector<FrameCandidates> all;
  for (const ScreenedFrame& frame : frames) {
    std::vector<Detection> seen;
    std::vector<std::vector<Pose>> own_squares;
    for (const int i : frame.detections) {
      seen.push_back(detections[i]);
      own_squares.push_back(squares[i]);
    }
    all.push_back({.time = frame.time,
                   .num_detections = static_cast<int>(seen.size()),
                   .poses = SolveView(camera, map, seen, own_squares, options)});
  }
  return all;
}

// The corner sigma from the best pose of each frame: the median of the frames' mean squares, each
// over the median of its chi-square (Wilson and Hilferty), which half of the frames may break. The
// best is here the quietest one that explains most of the frame.
std::optional<double> RobustSigma(std::span<const FrameCandidates> frames) {
  std::vector<double> variances;
  for (const FrameCandidates& frame : frames) {
    if (frame.poses.empty()) continue;
    const auto variance = [](const ViewPose& pose) {
      const double dof = pose.degrees_of_freedom;
      return pose.squared_error / (dof * std::pow(1.0 - 2.0 / (9.0 * dof), 3));
    };
    double least = variance(frame.poses.front());
    for (const ViewPose& pose : frame.poses) {
      const bool is_most = 2 * static_cast<int>(pose.used.size()) > frame.num_detections;
      if (is_most) least = std::min(least, variance(pose));
    }
    variances.push_back(least);
  }
  if (variances.empty()) return std::nullopt;
  return std::sqrt(Median(std::move(variances)));
}

void SetSigma(PoseTrack* track) {
  double sum = 0.0, dof = 0.0;
  for (const TrackedView& view : track->views) {
    sum += view.pose.squared_error / (view.pose.noise_scale * view.pose.noise_scale);
    dof += view.pose.degrees_of_freedom;
  }
  if (!(dof > 0.0)) return;
  track->corner_sigma = std::sqrt(sum / dof);
  // The variance of a chi-square over its dof is 2 / dof, that of its root half of it over two.
  track->corner_sigma_std = track->corner_sigma / std::sqrt(2.0 * dof);
}

// Of a detection in a frame without a pose. One seen from beyond 90 degrees, as by a fisheye,
// proposes none (SolveSquare), whatever is right or wrong with it.
Rejection WhyWithoutPose(const Detection& detection,
                         const CameraModel& camera,
                         double largest_angle) {
  const bool is_ahead = std::all_of(
      detection.corners.begin(), detection.corners.end(), [&](const Eigen::Vector2d& corner) {
        const auto ray = RayOf(camera, corner, largest_angle);
        return ray && ray->z() > 0.0;
      });
  return is_ahead ? Rejection::kOutlier : Rejection::kBeyondRight;
}

// Takes over the chosen poses, and accounts for every frame and detection.
void TakeOver(std::span<const Detection> detections,
              const CameraModel& camera,
              const std::vector<ScreenedFrame>& frames,
              const std::vector<FrameCandidates>& candidates,
              const std::vector<std::optional<int>>& chosen,
              double corner_sigma,
              PoseTrack* track) {
  constexpr double kAlmostAsWell = 9.0;
  const double largest_angle = LargestAngle(camera);
  track->views.clear();
  track->times_without_pose.clear();
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (!chosen[i]) {
      if (!frames[i].detections.empty()) track->times_without_pose.push_back(frames[i].time);
      for (const int index : frames[i].detections) {
        track->rejected.push_back(
            {.index = index, .reason = WhyWithoutPose(detections[index], camera, largest_angle)});
      }
      continue;
    }
    const std::vector<ViewPose>& poses = candidates[i].poses;
    TrackedView view;
    view.time = frames[i].time;
    view.pose = poses[*chosen[i]];
    for (const ViewPose& other : poses) {
      if (&other == &poses[*chosen[i]] || other.used.size() < view.pose.used.size()) continue;
      const double excess = other.squared_error - view.pose.squared_error;
      if (excess < 0.0) view.is_flip_resolved = true;
      const double sigma = corner_sigma * view.pose.noise_scale;
      if (std::abs(excess) < kAlmostAsWell * sigma * sigma) view.is_ambiguous = true;
    }
    std::size_t next_used = 0;
    for (std::size_t k = 0; k < frames[i].detections.size(); ++k) {
      const int index = frames[i].detections[k];
      const auto& used = view.pose.used;
      if (next_used < used.size() && used[next_used] == static_cast<int>(k)) {
        view.detections.push_back(index);
        ++next_used;
      } else {
        track->rejected.push_back({.index = index, .reason = Rejection::kOutlier});
      }
    }
    track->views.push_back(std::move(view));
  }
}

// "4, 7, 13": at most ten.
std::string ListOf(const std::map<int, int>& count_of_id) {
  std::vector<std::string> shown;
  for (const auto& [id, count] : count_of_id) {
    if (shown.size() == 10) {
      shown.push_back(fmt::format("... ({} ids in all)", count_of_id.size()));
      break;
    }
    shown.push_back(fmt::format("{} ({})", id, Plural(count, "time")));
  }
  return fmt::format("{}", fmt::join(shown, ", "));
}

}  // namespace

PoseTrack TrackPoses(std::span<const Detection> detections,
                     const CameraModel& camera,
                     const MarkerMap& map,
                     const PoseTrackOptions& options) {
  ScreenedDetections screened =
      ScreenDetections(detections, camera, map, options.frame_times, options.name);
  PoseTrack track;
  track.num_frames = static_cast<int>(screened.frames.size());
  track.num_detections = static_cast<int>(detections.size());
  for (ScreenedFrame& frame : screened.frames) {
    std::erase_if(frame.detections, [&](int i) {
      const bool is_surveyed = map.Find(detections[i].tag_id)->is_surveyed;
      if (!is_surveyed) {
        screened.rejected.push_back({.index = i, .reason = Rejection::kNotSurveyed});
      }
      return !is_surveyed;
    });
  }
  // Frames in which nothing was detected, and those of which nothing is left.
  std::vector<double> times_set_aside;
  std::size_t at = 0;
  for (const ScreenedFrame& frame : screened.frames) {
    while (at < detections.size() && detections[at].time < frame.time) ++at;
    const bool has_any = at < detections.size() && detections[at].time == frame.time;
    if (!has_any) ++track.num_frames_without_tags;
    if (has_any && frame.detections.empty()) times_set_aside.push_back(frame.time);
  }

  const auto squares = SquaresOf(detections, screened.frames, camera, map);
  const auto candidates_at = [&](const ViewPoseOptions& view_options) {
    return CandidatesOf(detections, squares, screened.frames, camera, map, view_options);
  };
  const std::optional<double> first_sigma =
      options.first_corner_sigma ? options.first_corner_sigma
                                 : RobustSigma(candidates_at({.gate = options.first_gate}));
  double sigma = first_sigma.value_or(1.0);
  // The gate follows from the sigma, and the sigma from what is inside the gate.
  constexpr int kMostRounds = 3;
  constexpr double kSmallestSigma = 1e-6;  // [px], of corners without noise
  for (int round = 0; round < kMostRounds; ++round) {
    sigma = std::max(sigma, kSmallestSigma);
    const auto candidates = candidates_at(
        {.gate = options.gate * sigma, .corner_sigma = sigma, .huber = options.huber * sigma});
    const auto chosen = ChoosePoses(candidates, {.corner_sigma = sigma});
    track.rejected = screened.rejected;
    TakeOver(detections, camera, screened.frames, candidates, chosen, sigma, &track);
    SetSigma(&track);
    if (!(std::abs(track.corner_sigma / sigma - 1.0) > 0.1)) break;
    sigma = track.corner_sigma;
  }
  track.times_without_pose.insert(
      track.times_without_pose.end(), times_set_aside.begin(), times_set_aside.end());
  std::sort(track.times_without_pose.begin(), track.times_without_pose.end());
  std::sort(track.rejected.begin(), track.rejected.end(), [](const auto& a, const auto& b) {
    return a.index < b.index;
  });
  return track;
}

std::vector<std::string> RemarksOn(const PoseTrack& track, std::span<const Detection> detections) {
  std::vector<std::string> remarks;
  if (track.num_frames_without_tags > 0) {
    remarks.push_back(fmt::format("{} of {} have no detection.",
                                  track.num_frames_without_tags,
                                  Plural(track.num_frames, "frame")));
  }
  if (!track.times_without_pose.empty()) {
    remarks.push_back(fmt::format("{} with tags gave no pose, the first at t = {}.",
                                  Plural(track.times_without_pose.size(), "frame"),
                                  track.times_without_pose.front()));
  }
  std::array<std::map<int, int>, kNumRejections> rejected;
  for (const RejectedDetection& one : track.rejected) {
    ++rejected[static_cast<std::size_t>(one.reason)][detections[one.index].tag_id];
  }
  for (int reason = 0; reason < kNumRejections; ++reason) {
    int count = 0;
    for (const auto& [id, times] : rejected[reason]) count += times;
    if (count == 0) continue;
    remarks.push_back(fmt::format("Set aside as {}: {} of {}: tags {}.",
                                  Name(static_cast<Rejection>(reason)),
                                  count,
                                  Plural(track.num_detections, "detection"),
                                  ListOf(rejected[reason])));
  }
  const auto count_views = [&](bool TrackedView::*flag) {
    return std::count_if(
        track.views.begin(), track.views.end(), [flag](const auto& view) { return view.*flag; });
  };
  if (const auto flips = count_views(&TrackedView::is_flip_resolved); flips > 0) {
    remarks.push_back(
        fmt::format("In {} of {} with a pose, the wrong one of two poses fits the corners best; "
                    "the neighbouring frames decided.",
                    flips,
                    Plural(track.views.size(), "frame")));
  }
  if (const auto ambiguous = count_views(&TrackedView::is_ambiguous); ambiguous > 0) {
    remarks.push_back(
        fmt::format("In {} of {} with a pose, two poses fit the corners almost equally well.",
                    ambiguous,
                    Plural(track.views.size(), "frame")));
  }
  return remarks;
}

}  // namespace fathom
