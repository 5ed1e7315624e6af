// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/marker_trajectory.h"

#include "fathom/base/input_error.h"
#include "fathom/marker_trajectory/bundle/bundle_adjustment.h"
#include "fathom/marker_trajectory/corner_noise.h"
#include "fathom/marker_trajectory/marker_conflicts.h"
#include "fathom/marker_trajectory/marker_remarks.h"
#include "fathom/marker_trajectory/moved_markers.h"
#include "fathom/marker_trajectory/place_more_markers.h"
#include "fathom/marker_trajectory/pose_bias.h"
#include "fathom/marker_trajectory/survey_misfit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

// The surveyed marker seen most often.
int ReferenceOf(std::span<const Detection> detections,
                const PoseTrack& track,
                const MarkerMap& map,
                const MarkerTrajectoryOptions& options) {
  if (options.reference_id) {
    const Marker* marker = map.Find(*options.reference_id);
    if (marker == nullptr || !marker->is_surveyed) {
      throw InputError(
          fmt::format("reference tag {}: is no surveyed tag of tags.yaml, expected one.",
                      *options.reference_id));
    }
    return *options.reference_id;
  }
  std::map<int, int> count;
  for (const TrackedView& view : track.views) {
    for (const int i : view.detections) {
      const int id = detections[i].tag_id;
      if (map.Find(id)->is_surveyed) ++count[id];
    }
  }
  const auto most = std::max_element(
      count.begin(), count.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == count.end() ? map.markers.front().id : most->first;
}

// The free markers that at least one view rests on.
std::set<int> SeenOf(const std::set<int>& free_ids,
                     std::span<const Detection> detections,
                     const PoseTrack& track) {
  std::set<int> seen;
  for (const TrackedView& view : track.views) {
    for (const int i : view.detections) {
      if (free_ids.contains(detections[i].tag_id)) seen.insert(detections[i].tag_id);
    }
  }
  return seen;
}

BundleAdjustmentSummary Adjust(std::span<const Detection> detections,
                               const CameraModel& camera,
                               const MarkerMap& map,
                               const std::set<int>& free_ids,
                               const PoseTrack& track,
                               double huber) {
  std::vector<AdjustedFrame> frames;
  for (const TrackedView& view : track.views) {
    frames.push_back({view.pose.world_from_camera, view.detections, view.pose.noise_scale});
  }
  BundleAdjustmentOptions options;
  constexpr double kSmallestSigma = 1e-6;  // [px], of corners without noise
  if (!frames.empty()) options.corner_sigma = std::max(track.corner_sigma, kSmallestSigma);
  options.huber = huber;
  return AdjustBundle(
      camera, map, SeenOf(free_ids, detections, track), detections, frames, options);
}

// Takes back the places that were found and that the adjustment did not use, since no view agrees
// with them. Returns whose.
std::vector<int> TakeBackUnusedPlaces(const MarkerMap& survey,
                                      const std::vector<int>& estimated_ids,
                                      MarkerMap* map) {
  std::vector<int> refuted;
  for (Marker& marker : map->markers) {
    const bool was_found = marker.is_surveyed && !survey.Find(marker.id)->is_surveyed;
    const bool is_used = std::count(estimated_ids.begin(), estimated_ids.end(), marker.id) > 0;
    if (!was_found || is_used) continue;
    marker = *survey.Find(marker.id);
    refuted.push_back(marker.id);
  }
  return refuted;
}

void TakeOver(const BundleAdjustmentSummary& summary,
              std::span<const Detection> detections,
              const CameraModel& camera,
              const Pose& body_from_camera,
              MarkerTrack* out) {
  std::vector<std::vector<int>> tag_ids;
  for (std::size_t i = 0; i < summary.world_from_camera.size(); ++i) {
    const TrackedView& view = out->pnp.views[i];
    out->world_from_camera.push_back({.time = view.time,
                                      .pose = summary.world_from_camera[i],
                                      .covariance = summary.pose_covariance[i]});
    std::vector<int>& ids = tag_ids.emplace_back();
    for (const int k : view.detections) ids.push_back(detections[k].tag_id);
  }
  // What does not fit for other reasons is not noise, and has another mean.
  out->corner_noise =
      CornerNoise(camera, summary.map, detections, out->pnp.views, out->world_from_camera);
  RemoveBias(camera,
             summary.map,
             tag_ids,
             std::fmin(out->corner_noise, summary.corner_sigma),
             &out->world_from_camera);
  const Pose camera_from_body = body_from_camera.Inverse();
  for (const StampedPose& one : out->world_from_camera) {
    out->world_from_body.push_back(
        {.time = one.time,
         .pose = one.pose * camera_from_body,
         .covariance = CovarianceOfComposed(one.pose, one.covariance, camera_from_body)});
  }
  out->frame_rms = summary.frame_rms;
  out->corner_sigma = summary.corner_sigma;
  out->corner_sigma_std = summary.corner_sigma_std;
  out->map = summary.map;
  out->estimated_ids = summary.free_ids;
  out->marker_covariance = summary.marker_covariance;
}

// The markers that the track looks for places for, and, where surveyed ones are among them, the one
// that holds the world.
struct FreeMarkers {
  std::set<int> ids;
  std::optional<int> reference = {};
};

FreeMarkers FreeMarkersOf(std::span<const Detection> detections,
                          const PoseTrack& track,
                          const MarkerMap& map,
                          const MarkerTrajectoryOptions& options) {
  FreeMarkers free;
  for (const Marker& marker : map.markers) {
    if (!marker.is_surveyed) free.ids.insert(marker.id);
  }
  if (!options.estimate_surveyed_markers || track.views.empty()) return free;
  free.reference = ReferenceOf(detections, track, map, options);
  for (const Marker& marker : map.markers) free.ids.insert(marker.id);
  free.ids.erase(*free.reference);
  return free;
}

// The markers that were seen and have no place.
std::vector<int> UnplacedOf(std::span<const Detection> detections, const PoseTrack& track) {
  std::set<int> unplaced;
  for (const RejectedDetection& one : track.rejected) {
    if (one.reason == Rejection::kNotSurveyed) unplaced.insert(detections[one.index].tag_id);
  }
  return {unplaced.begin(), unplaced.end()};
}

// Outwards from the surveyed markers, as far as views hang together. After each step all poses and
// the places found so far are adjusted, so that errors do not add up on the way. A place that no
// view agrees with is looked for again. Returns the track over the markers then placed.
PoseTrack PlaceOutwards(std::span<const Detection> detections,
                        const CameraModel& camera,
                        const MarkerTrajectoryOptions& options,
                        MarkerMap* placed) {
  const MarkerMap survey = *placed;
  constexpr int kMostTries = 3;
  std::map<int, int> num_tries;
  std::set<int> found;
  PoseTrack track = TrackPoses(detections, camera, *placed, options.pose_track);
  while (PlaceMoreMarkers(detections, camera, track, placed)) {
    PoseTrackOptions next = options.pose_track;
    next.first_corner_sigma = track.corner_sigma;
    track = TrackPoses(detections, camera, *placed, next);
    for (const Marker& marker : placed->markers) {
      if (marker.is_surveyed && !survey.Find(marker.id)->is_surveyed) found.insert(marker.id);
    }
    const BundleAdjustmentSummary fit =
        Adjust(detections, camera, *placed, found, track, options.pose_track.huber);
    if (!fit.is_usable) continue;
    *placed = fit.map;
    for (Marker& marker : placed->markers) {
      const bool is_unused =
          found.contains(marker.id) && std::ranges::count(fit.free_ids, marker.id) == 0;
      if (!is_unused || ++num_tries[marker.id] == kMostTries) continue;
      marker = *survey.Find(marker.id);
      found.erase(marker.id);
    }
    for (std::size_t i = 0; i < track.views.size(); ++i) {
      track.views[i].pose.world_from_camera = fit.world_from_camera[i];
    }
  }
  return track;
}

// The track without its remarks.
MarkerTrack TrackOnce(std::span<const Detection> detections,
                      const CameraModel& camera,
                      const MarkerMap& map,
                      const Pose& body_from_camera,
                      const MarkerTrajectoryOptions& options,
                      std::optional<int>* reference) {
  MarkerTrack result;
  MarkerMap placed = map;
  result.pnp = PlaceOutwards(detections, camera, options, &placed);
  const FreeMarkers free = FreeMarkersOf(detections, result.pnp, map, options);
  const double huber = options.pose_track.huber;
  BundleAdjustmentSummary summary = Adjust(detections, camera, placed, free.ids, result.pnp, huber);
  if (summary.is_usable && !summary.free_ids.empty()) {
    // With the markers in place the gate is as narrow as the corners allow: once more.
    placed = summary.map;
    result.pnp = TrackPoses(detections, camera, placed, options.pose_track);
    summary = Adjust(detections, camera, placed, free.ids, result.pnp, huber);
  }
  result.map = placed;
  result.message = summary.message;
  if (summary.is_usable) TakeOver(summary, detections, camera, body_from_camera, &result);
  result.refuted_ids = TakeBackUnusedPlaces(map, result.estimated_ids, &result.map);
  result.unplaced_ids = UnplacedOf(detections, result.pnp);
  if (result.IsUsable()) result.moved_markers = FindMovedMarkers(camera, detections, result);
  *reference = free.reference;
  return result;
}

// Whether a track tells of markers that agree with others for a part of the record only, and rests
// on most of the detections.
bool IsTold(std::span<const Detection> detections, const MarkerTrack& track) {
  if (!track.moved_markers.empty()) return true;
  const auto num_outliers =
      std::ranges::count(track.pnp.rejected, Rejection::kOutlier, &RejectedDetection::reason);
  if (3 * num_outliers > track.pnp.num_detections) return false;
  return std::ranges::any_of(FindMarkerConflicts(detections, track),
                             [](const MarkerConflict& one) { return !one.agrees_with.empty(); });
}

}  // namespace

MarkerTrack TrackMarkers(std::span<const Detection> detections,
                         const CameraModel& camera,
                         const MarkerMap& map,
                         const Pose& body_from_camera,
                         const MarkerTrajectoryOptions& options) {
  std::optional<int> reference;
  MarkerTrack result = TrackOnce(detections, camera, map, body_from_camera, options, &reference);
  if (IsSurveyInDoubt(result)) {
    // A marker that moves in the first half of a record, or is seen with wrong ones for most of it,
    // widens the gate to where it is no outlier.
    MarkerTrajectoryOptions narrow = options;
    narrow.pose_track.first_corner_sigma = result.corner_noise;
    MarkerTrack other = TrackOnce(detections, camera, map, body_from_camera, narrow, &reference);
    if (IsTold(detections, other) && !IsSurveyInDoubt(other)) result = std::move(other);
  }
  result.remarks = RemarksOn(result, reference, detections, camera);
  return result;
}

}  // namespace fathom
