// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/marker_placement.h"

#include "fathom/marker_trajectory/bundle/bundle_adjustment.h"
#include "fathom/track/view_pose.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

namespace fathom {
namespace {

constexpr std::size_t kMostProposers = 8;
constexpr std::size_t kMostJudges = 24;
constexpr std::size_t kMostAdjusted = 6;
constexpr double kOutlier = 20.0;  // rms of a frame's corners [px]

// A frame with the poses of its squares, which do not depend on where the markers are.
struct SolvedFrame {
  std::vector<Detection> detections;
  std::vector<std::vector<Pose>> squares;
};

// At most `most` frames, spread over all.
std::vector<SolvedFrame> Spread(const CameraModel& camera,
                                const MarkerMap& map,
                                std::span<const std::vector<Detection>> frames,
                                std::size_t most) {
  std::vector<SolvedFrame> some;
  const std::size_t count = std::min(most, frames.size());
  for (std::size_t k = 0; k < count; ++k) {
    SolvedFrame frame;
    frame.detections = frames[k * frames.size() / count];
    for (const Detection& detection : frame.detections) {
      frame.squares.push_back(
          SolveSquare(camera, map.Find(detection.tag_id)->size, detection.corners));
    }
    some.push_back(std::move(frame));
  }
  return some;
}

// What one frame proposes: from the known markers to the camera, from there to the marker.
void Propose(const CameraModel& camera,
             const MarkerMap& map,
             int id,
             const SolvedFrame& frame,
             std::vector<Pose>* proposals) {
  SolvedFrame known;
  std::vector<Pose> camera_from_tag;
  for (std::size_t i = 0; i < frame.detections.size(); ++i) {
    if (frame.detections[i].tag_id == id) {
      camera_from_tag = frame.squares[i];
    } else {
      known.detections.push_back(frame.detections[i]);
      known.squares.push_back(frame.squares[i]);
    }
  }
  for (const ViewPose& view : SolveView(camera, map, known.detections, known.squares)) {
    for (const Pose& square : camera_from_tag) {
      proposals->push_back(view.world_from_camera * square);
    }
  }
}

void PutMarker(int id, const Pose& world_from_tag, MarkerMap* map) {
  for (Marker& marker : map->markers) {
    if (marker.id == id) marker.world_from_tag = world_from_tag;
  }
}

// Mean square of a frame's corners for its best pose [px^2], at most that of an outlier. A
// detection that the pose leaves out counts as one.
double Judge(const CameraModel& camera, const MarkerMap& map, const SolvedFrame& frame) {
  const double worst = kOutlier * kOutlier;
  const auto poses = SolveView(camera, map, frame.detections, frame.squares, {.gate = kOutlier});
  if (poses.empty()) return worst;
  const double count = static_cast<double>(frame.detections.size());
  const double num_left_out = count - static_cast<double>(poses.front().used.size());
  return std::min((poses.front().squared_error / 4.0 + num_left_out * worst) / count, worst);
}

// The place after an adjustment with the judges' poses, and its score; infinite if it fails.
std::pair<double, Pose> Adjusted(const CameraModel& camera,
                                 const MarkerMap& map,
                                 int id,
                                 const std::vector<SolvedFrame>& judges) {
  std::vector<Detection> detections;
  std::vector<AdjustedFrame> frames;
  for (const SolvedFrame& judge : judges) {
    const auto poses = SolveView(camera, map, judge.detections, judge.squares, {.gate = kOutlier});
    if (poses.empty()) continue;
    AdjustedFrame frame = {.world_from_camera = poses.front().world_from_camera, .detections = {}};
    for (const int i : poses.front().used) {
      frame.detections.push_back(static_cast<int>(detections.size()));
      detections.push_back(judge.detections[i]);
    }
    frames.push_back(std::move(frame));
  }
  const bool is_seen = std::any_of(
      detections.begin(), detections.end(), [id](const auto& one) { return one.tag_id == id; });
  MarkerMap adjusted = map;
  if (is_seen) {
    const auto summary =
        AdjustBundle(camera, map, {id}, detections, frames, {.corner_sigma = 1.0, .huber = 3.0});
    if (summary.is_usable) adjusted = summary.map;
  }
  double score = 0.0;
  for (const SolvedFrame& judge : judges) score += Judge(camera, adjusted, judge);
  return {score, adjusted.Find(id)->world_from_tag};
}

}  // namespace

std::optional<Pose> PlaceMarker(const CameraModel& camera,
                                const MarkerMap& map,
                                int id,
                                std::span<const std::vector<Detection>> frames) {
  std::vector<Pose> proposals;
  for (const SolvedFrame& frame : Spread(camera, map, frames, kMostProposers)) {
    Propose(camera, map, id, frame, &proposals);
  }
  const std::vector<SolvedFrame> judges = Spread(camera, map, frames, kMostJudges);
  MarkerMap tried = map;
  std::vector<std::pair<double, std::size_t>> scores;
  for (std::size_t k = 0; k < proposals.size(); ++k) {
    PutMarker(id, proposals[k], &tried);
    double score = 0.0;
    for (const SolvedFrame& judge : judges) score += Judge(camera, tried, judge);
    scores.emplace_back(score, k);
  }
  std::sort(scores.begin(), scores.end());
  if (scores.size() > kMostAdjusted) scores.resize(kMostAdjusted);

  std::optional<Pose> best;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [rough_score, k] : scores) {
    PutMarker(id, proposals[k], &tried);
    const auto [score, place] = Adjusted(camera, tried, id, judges);
    if (score < least) {
      least = score;
      best = place;
    }
  }
  return best;
}

}  // namespace fathom
