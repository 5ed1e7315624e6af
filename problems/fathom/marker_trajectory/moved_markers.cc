// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/moved_markers.h"

#include "fathom/base/median.h"
#include "fathom/geometry/pose_increment.h"
#include "fathom/marker_trajectory/bundle/bundle_adjustment.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <optional>
#include <set>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::size_t kFewest = 10;  // detections of a marker on either side of its move

constexpr double kNearlyAll = 0.8;

// A detection of one marker in a frame whose pose rests on others too.
struct Sighting {
  std::size_t view = 0;
  int detection = 0;
  bool is_outlier = false;
};

bool RestsOnOthers(const TrackedView& view, int tag_id, std::span<const Detection> detections) {
  return std::any_of(view.detections.begin(), view.detections.end(), [&](int i) {
    return detections[i].tag_id != tag_id;
  });
}

// By marker, by time.
std::map<int, std::vector<Sighting>> SightingsOf(std::span<const Detection> detections,
                                                 const PoseTrack& track) {
  std::set<int> outliers;
  for (const RejectedDetection& one : track.rejected) {
    if (one.reason == Rejection::kOutlier) outliers.insert(one.index);
  }
  std::map<int, std::vector<Sighting>> sightings;
  const auto add = [&](std::size_t view, int i, bool is_outlier) {
    const int id = detections[i].tag_id;
    if (!RestsOnOthers(track.views[view], id, detections)) return;
    sightings[id].push_back({view, i, is_outlier});
  };
  auto outlier = outliers.begin();
  for (std::size_t v = 0; v < track.views.size(); ++v) {
    const double time = track.views[v].time;
    for (const int i : track.views[v].detections) add(v, i, false);
    while (outlier != outliers.end() && detections[*outlier].time < time) ++outlier;
    for (; outlier != outliers.end() && detections[*outlier].time == time; ++outlier) {
      add(v, *outlier, true);
    }
  }
  return sightings;
}

// n log-likelihood of `k` in `n` at their own rate.
double LogLikelihood(double k, double n) {
  const auto part = [n](double count) { return count > 0.0 ? count * std::log(count / n) : 0.0; };
  return part(k) + part(n - k);
}

// The first sighting behind a change from few outliers to nearly all, by maximum likelihood.
std::optional<std::size_t> ChangeOf(const std::vector<Sighting>& sightings) {
  constexpr double kFew = 0.3;
  const auto n = sightings.size();
  double all = 0.0;
  for (const Sighting& one : sightings) all += one.is_outlier;
  std::optional<std::size_t> best;
  double most = 0.0, before = 0.0;
  for (std::size_t i = 1; i < n; ++i) {
    before += sightings[i - 1].is_outlier;
    const auto num_before = static_cast<double>(i), num_after = static_cast<double>(n - i);
    if (i < kFewest || n - i < kFewest) continue;
    if (before > kFew * num_before || all - before < kNearlyAll * num_after) continue;
    const double value = LogLikelihood(before, num_before) + LogLikelihood(all - before, num_after);
    if (!best || value > most) best = i, most = value;
  }
  return best;
}

// Of the sightings from `change` on, those in frames whose pose rests on a marker that agreed with
// this one before.
std::vector<Sighting> AfterWithPartners(std::span<const Sighting> sightings,
                                        std::size_t change,
                                        std::span<const Detection> detections,
                                        const PoseTrack& track) {
  std::set<int> partners;
  for (const Sighting& one : sightings.first(change)) {
    if (one.is_outlier) continue;
    for (const int i : track.views[one.view].detections) partners.insert(detections[i].tag_id);
  }
  partners.erase(detections[sightings.front().detection].tag_id);
  std::vector<Sighting> after;
  for (const Sighting& one : sightings.subspan(change)) {
    const std::vector<int>& used = track.views[one.view].detections;
    const bool has_partner =
        std::ranges::any_of(used, [&](int i) { return partners.contains(detections[i].tag_id); });
    if (has_partner) after.push_back(one);
  }
  return after;
}

// Nearly all are outliers, and most of the last.
bool StaysMoved(std::span<const Sighting> after) {
  const auto num_outliers = [](std::span<const Sighting> some) {
    return static_cast<double>(std::ranges::count_if(some, &Sighting::is_outlier));
  };
  if (after.size() < kFewest) return false;
  return num_outliers(after) >= kNearlyAll * static_cast<double>(after.size()) &&
         num_outliers(after.last(kFewest)) > 0.5 * static_cast<double>(kFewest);
}

// Frames behind the change, spread over them, with the marker's detection among those that the pose
// rests on.
std::vector<AdjustedFrame> SomeFramesOf(std::span<const Sighting> after, const MarkerTrack& track) {
  constexpr std::size_t kMost = 100;
  const std::size_t step = std::max<std::size_t>(1, after.size() / kMost);
  std::vector<AdjustedFrame> frames;
  for (std::size_t k = 0; k < after.size(); k += step) {
    const Sighting& one = after[k];
    if (!one.is_outlier) continue;
    const TrackedView& view = track.pnp.views[one.view];
    AdjustedFrame frame = {
        track.world_from_camera[one.view].pose, view.detections, view.pose.noise_scale};
    frame.detections.push_back(one.detection);
    frames.push_back(std::move(frame));
  }
  return frames;
}

// The frames without those that fit far worse than most, which show a false decode.
std::vector<AdjustedFrame> WithoutFalse(const std::vector<AdjustedFrame>& frames,
                                        const std::vector<double>& rms) {
  constexpr double kFarWorse = 3.0;
  const double typical = Median(rms);
  std::vector<AdjustedFrame> kept;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (rms[i] <= kFarWorse * typical) kept.push_back(frames[i]);
  }
  return kept;
}

// Where the marker has gone to; nothing if no single place explains what shows it.
std::optional<MovedMarker> MoveOf(const CameraModel& camera,
                                  std::span<const Detection> detections,
                                  const MarkerTrack& track,
                                  int tag_id,
                                  std::span<const Sighting> after) {
  constexpr double kExplained = 1.5;  // corner sigmas
  constexpr double kFarOff = 5.0;     // standard deviations
  const auto adjust = [&](std::span<const AdjustedFrame> frames) {
    return AdjustBundle(
        camera, track.map, {tag_id}, detections, frames, {.corner_sigma = track.corner_sigma});
  };
  const std::vector<AdjustedFrame> all = SomeFramesOf(after, track);
  BundleAdjustmentSummary fit = adjust(all);
  if (!fit.is_usable) return std::nullopt;
  const std::vector<AdjustedFrame> kept = WithoutFalse(all, fit.frame_rms);
  if (static_cast<double>(kept.size()) < kNearlyAll * static_cast<double>(all.size())) {
    return std::nullopt;
  }
  fit = adjust(kept);
  if (!fit.is_usable || !(fit.corner_sigma < kExplained * track.corner_sigma)) return std::nullopt;
  const PoseIncrement step =
      StepBetween(track.map.Find(tag_id)->world_from_tag, fit.map.Find(tag_id)->world_from_tag);
  const PoseCovariance& covariance = fit.marker_covariance.front();
  MovedMarker moved = {.tag_id = tag_id, .time = detections[after.front().detection].time};
  moved.distance = step.head<3>().norm();
  moved.angle = step.tail<3>().norm();
  const Eigen::Vector3d along = step.head<3>() / moved.distance;
  moved.distance_std = std::sqrt(along.dot(covariance.topLeftCorner<3, 3>() * along));
  const bool has_moved = step.dot(covariance.ldlt().solve(step)) > kFarOff * kFarOff;
  return has_moved ? std::optional(moved) : std::nullopt;
}

}  // namespace

std::vector<MovedMarker> FindMovedMarkers(const CameraModel& camera,
                                          std::span<const Detection> detections,
                                          const MarkerTrack& track) {
  std::vector<MovedMarker> found;
  for (const auto& [id, sightings] : SightingsOf(detections, track.pnp)) {
    if (std::ranges::count(track.estimated_ids, id) > 0) continue;
    const std::optional<std::size_t> change = ChangeOf(sightings);
    if (!change) continue;
    const auto after = AfterWithPartners(sightings, *change, detections, track.pnp);
    if (!StaysMoved(after)) continue;
    if (const auto moved = MoveOf(camera, detections, track, id, after)) found.push_back(*moved);
  }
  return found;
}

std::string RemarkOn(const MovedMarker& moved) {
  return fmt::format(
      "Tag {} sits {:.2g} cm (± {:.1g} cm) elsewhere, turned by {:.1f} degrees, from t = {:.1f} s "
      "on. Its detections are set aside from then on. Measure it again, or cut the log there.",
      moved.tag_id,
      100.0 * moved.distance,
      100.0 * moved.distance_std,
      moved.angle * 180.0 / std::numbers::pi,
      moved.time);
}

}  // namespace fathom
