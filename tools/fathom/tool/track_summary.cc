// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/track_summary.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using Json = nlohmann::ordered_json;

double Quantile(const std::vector<double>& rising, double share) {
  if (rising.empty()) return std::nan("");
  return rising[static_cast<std::size_t>(share * static_cast<double>(rising.size() - 1))];
}

double Rms(const std::vector<double>& numbers) {
  double square = 0.0;
  for (const double x : numbers) square += x * x;
  return std::sqrt(square / static_cast<double>(numbers.size()));
}

// null for what was not computed.
Json NumberOrNull(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

int NumExpected(const TrackSummary& summary) {
  const int num_read = summary.num_frames;
  return summary.images ? num_read + summary.images->num_unreadable : num_read;
}

std::vector<double> TimesOfFlips(const MarkerTrack& track, bool TrackedView::*which) {
  std::vector<double> times;
  for (const TrackedView& view : track.pnp.views) {
    if (view.*which) times.push_back(view.time);
  }
  return times;
}

Json FramesOf(const TrackSummary& summary, const MarkerTrack& track) {
  Json frames;
  frames["expected"] = NumExpected(summary);
  frames["read"] = summary.num_frames;
  frames["unreadable"] = summary.images ? summary.images->num_unreadable : 0;
  // Detections alone do not list the frames that have none.
  const std::vector<double> times_without_tags =
      summary.images ? summary.images->times_without_tags : std::vector<double>{};
  frames["without_tags"] = times_without_tags.size();
  frames["times_without_tags"] = times_without_tags;
  frames["times_with_unused_tags_only"] =
      summary.images ? Json(summary.images->times_with_unused_only) : Json::array();
  frames["with_pose"] = track.world_from_body.size();
  frames["share_with_pose"] = NumberOrNull(summary.ShareWithPose(track));
  frames["unreadable_ones"] =
      summary.images ? Json(summary.images->unreadable) : Json(std::vector<std::string>{});
  frames["times_without_pose"] = track.pnp.times_without_pose;
  return frames;
}

Json DetectionsOf(const TrackSummary& summary,
                  const MarkerTrack& track,
                  std::span<const Detection> detections) {
  Json found;
  found["found"] = summary.num_detections;
  // Not known of corners that were read.
  found["sides_not_followed"] =
      summary.images ? Json(summary.images->num_not_followed) : Json(nullptr);
  found["rejected"] = track.pnp.rejected.size();
  Json rejected = Json::array();
  for (const RejectedDetection& it : track.pnp.rejected) {
    const Detection& detection = detections[it.index];
    rejected.push_back({{"t", detection.time},
                        {"tag_id", detection.tag_id},
                        {"reason", std::string(Name(it.reason))}});
  }
  found["rejected_ones"] = rejected;
  Json unused = Json::array();
  if (summary.images) {
    for (const UnusedSighting& it : summary.images->unused) {
      unused.push_back({{"t", it.time},
                        {"family", it.sighting.family},
                        {"tag_id", it.sighting.tag_id},
                        {"hamming", it.sighting.hamming},
                        {"reason", std::string(Describe(it.fault))}});
    }
  }
  found["sightings_not_used"] = unused;
  return found;
}

Json FitOf(const TrackSummary& summary, const MarkerTrack& track) {
  Json fit;
  fit["corner_sigma_px"] = NumberOrNull(track.corner_sigma);
  fit["corner_noise_px"] = NumberOrNull(track.corner_noise);
  fit["corner_sigma_std_px"] = NumberOrNull(track.corner_sigma_std);
  fit["reprojection_median_px"] = NumberOrNull(Quantile(summary.corner_error, 0.5));
  fit["reprojection_rms_px"] = NumberOrNull(Rms(summary.corner_error));
  fit["reprojection_p95_px"] = NumberOrNull(Quantile(summary.corner_error, 0.95));
  fit["times_of_resolved_flips"] = TimesOfFlips(track, &TrackedView::is_flip_resolved);
  fit["times_left_ambiguous"] = TimesOfFlips(track, &TrackedView::is_ambiguous);
  return fit;
}

}  // namespace

double TrackSummary::ShareWithPose(const MarkerTrack& track) const {
  const int num = NumExpected(*this);
  return num == 0 ? std::nan("") : static_cast<double>(track.world_from_body.size()) / num;
}

TrackSummary Summarize(const std::string& log,
                       const std::optional<TagDetections>& images,
                       std::span<const Detection> detections,
                       const CameraModel& camera,
                       const MarkerMap& map,
                       const MarkerTrack& track) {
  TrackSummary summary;
  summary.log = log;
  summary.images = images;
  summary.num_detections = static_cast<int>(detections.size());
  summary.num_frames = track.pnp.num_frames;
  if (images) {
    for (const std::string& remark : RemarksOn(*images, map)) {
      summary.remarks.push_back({RemarkKind::kDetections, remark});
    }
  }
  summary.remarks.insert(summary.remarks.end(), track.remarks.begin(), track.remarks.end());

  std::set<int> rejected;
  for (const RejectedDetection& it : track.pnp.rejected) rejected.insert(it.index);
  std::map<double, const Pose*> pose_at;
  for (const StampedPose& it : track.world_from_camera) pose_at[it.time] = &it.pose;
  for (std::size_t i = 0; i < detections.size(); ++i) {
    const auto pose = pose_at.find(detections[i].time);
    const Marker* marker = track.map.Find(detections[i].tag_id);
    if (pose == pose_at.end() || marker == nullptr || !marker->is_surveyed ||
        rejected.contains(static_cast<int>(i))) {
      continue;
    }
    const Pose camera_from_tag = pose->second->Inverse() * marker->world_from_tag;
    const auto corners_in_tag = CornersInTag(marker->size);
    for (int corner = 0; corner < 4; ++corner) {
      const Eigen::Vector3d x_camera = camera_from_tag * corners_in_tag[corner];
      summary.corner_error.push_back(
          (Project(camera, x_camera) - detections[i].corners[corner]).norm());
    }
  }
  std::sort(summary.corner_error.begin(), summary.corner_error.end());
  return summary;
}

std::string FormatText(const TrackSummary& summary, const MarkerTrack& track) {
  std::string text;
  const auto add = [&](std::string_view name, const std::string& value) {
    fmt::format_to(std::back_inserter(text), "{:<20}{}\n", name, value);
  };
  const int num_with_pose = static_cast<int>(track.world_from_body.size());
  if (summary.images) {
    add("frames",
        fmt::format("{} read, {} unreadable, {} without tags, {} with unused tags only",
                    summary.images->frame_times.size(),
                    summary.images->num_unreadable,
                    summary.images->times_without_tags.size(),
                    summary.images->times_with_unused_only.size()));
    add("sightings not used", std::to_string(summary.images->unused.size()));
    add("sides not followed", std::to_string(summary.images->num_not_followed));
  } else {
    add("frames",
        fmt::format("{} with detections (detections.csv lists no others)", summary.num_frames));
  }
  add("frames with a pose",
      fmt::format("{} ({:.1f} %{})",
                  num_with_pose,
                  100.0 * summary.ShareWithPose(track),
                  summary.images ? "" : " of these"));
  add("detections",
      fmt::format("{} found, {} rejected", summary.num_detections, track.pnp.rejected.size()));
  add("corner sigma",
      fmt::format("{:.3f} px{}",
                  track.corner_sigma,
                  std::isfinite(track.corner_noise)
                      ? fmt::format(", noise from frame to frame {:.3f} px", track.corner_noise)
                      : ""));
  add("reprojection error",
      fmt::format("median {:.3f} px, rms {:.3f} px, 95 % below {:.3f} px",
                  Quantile(summary.corner_error, 0.5),
                  Rms(summary.corner_error),
                  Quantile(summary.corner_error, 0.95)));
  add("flips",
      fmt::format("{} resolved, {} left ambiguous",
                  TimesOfFlips(track, &TrackedView::is_flip_resolved).size(),
                  TimesOfFlips(track, &TrackedView::is_ambiguous).size()));
  if (!track.estimated_ids.empty()) {
    add("markers estimated", fmt::format("{}", track.estimated_ids.size()));
  }
  return text;
}

std::string FormatJson(const TrackSummary& summary,
                       const MarkerTrack& track,
                       std::span<const Detection> detections) {
  Json json;
  json["schema"] = "fathom-track-1";
  json["log"] = summary.log;
  json["message"] = track.message;
  json["usable"] = track.IsUsable();
  json["frames"] = FramesOf(summary, track);
  json["detections"] = DetectionsOf(summary, track, detections);
  json["fit"] = FitOf(summary, track);
  json["markers_estimated"] = track.estimated_ids;
  json["markers_not_placed"] = track.unplaced_ids;
  json["remarks"] = TextsOf(summary.remarks);
  return json.dump(1) + "\n";
}

}  // namespace fathom
