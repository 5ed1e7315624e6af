// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/marker_conflicts.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// How often two markers were in one frame.
struct Meetings {
  int agree = 0;       // the pose rests on both
  int contradict = 0;  // the pose rests on the second, and the first is set aside
};

struct AllMeetings {
  std::map<int, std::map<int, Meetings>> of;  // of[a][b]
  std::map<double, std::set<int>> outliers;   // ids set aside at a time
};

AllMeetings MeetingsOf(std::span<const Detection> detections, const PoseTrack& track) {
  AllMeetings all;
  for (const RejectedDetection& one : track.rejected) {
    if (one.reason != Rejection::kOutlier) continue;
    all.outliers[detections[one.index].time].insert(detections[one.index].tag_id);
  }
  for (const TrackedView& view : track.views) {
    for (const int i : view.detections) {
      const int b = detections[i].tag_id;
      for (const int k : view.detections) {
        if (k != i) ++all.of[detections[k].tag_id][b].agree;
      }
      const auto outliers = all.outliers.find(view.time);
      if (outliers == all.outliers.end()) continue;
      for (const int a : outliers->second) ++all.of[a][b].contradict;
    }
  }
  return all;
}

bool IsWhenever(const Meetings& meetings) {
  constexpr int kFewest = 10;
  constexpr double kNearlyAll = 0.8;
  return meetings.contradict >= kFewest &&
         meetings.contradict >= kNearlyAll * (meetings.contradict + meetings.agree);
}

// The frames whose pose rests on one of `against`, and that set `id` aside.
int NumFrames(int id,
              const std::vector<int>& against,
              std::span<const Detection> detections,
              const PoseTrack& track,
              const AllMeetings& all) {
  return static_cast<int>(std::ranges::count_if(track.views, [&](const TrackedView& view) {
    const auto outliers = all.outliers.find(view.time);
    return outliers != all.outliers.end() && outliers->second.contains(id) &&
           std::ranges::any_of(view.detections, [&](int i) {
             return std::ranges::count(against, detections[i].tag_id) > 0;
           });
  }));
}

std::string TagsOf(const std::vector<int>& ids) {
  return fmt::format("{} {}", ids.size() == 1 ? "tag" : "tags", fmt::join(ids, ", "));
}

}  // namespace

std::vector<MarkerConflict> FindMarkerConflicts(std::span<const Detection> detections,
                                                const MarkerTrack& track) {
  const AllMeetings all = MeetingsOf(detections, track.pnp);
  std::vector<MarkerConflict> conflicts;
  for (const auto& [id, with_others] : all.of) {
    const auto is_this = [id = id](const MovedMarker& moved) { return moved.tag_id == id; };
    if (std::ranges::any_of(track.moved_markers, is_this)) continue;
    if (std::ranges::count(track.estimated_ids, id) > 0) continue;
    if (!track.map.Find(id)->is_surveyed) continue;
    MarkerConflict conflict = {.tag_id = id, .against = {}, .agrees_with = {}};
    for (const auto& [other, meetings] : with_others) {
      if (IsWhenever(meetings)) {
        conflict.against.push_back(other);
      } else if (meetings.agree > meetings.contradict) {
        conflict.agrees_with.push_back(other);
      }
    }
    if (conflict.against.empty()) continue;
    conflict.num_frames = NumFrames(id, conflict.against, detections, track.pnp, all);
    conflicts.push_back(std::move(conflict));
  }
  return conflicts;
}

std::vector<std::string> RemarksOn(std::span<const MarkerConflict> conflicts) {
  std::vector<std::string> remarks;
  std::vector<int> alone;
  for (const MarkerConflict& one : conflicts) {
    if (one.agrees_with.empty() && one.against.size() > 1) {
      alone.push_back(one.tag_id);
      continue;
    }
    const std::string against = TagsOf(one.against);
    remarks.push_back(fmt::format(
        "Tag {} contradicts {} whenever they are seen together ({} frames){}. Either tag {} was "
        "elsewhere in these frames, or {} {} not where tags.yaml says. The poses of these frames "
        "rest on {} and are wrong if the latter is true. Measure these tags again.",
        one.tag_id,
        against,
        one.num_frames,
        one.agrees_with.empty() ? std::string()
                                : fmt::format(", and agrees with {}", TagsOf(one.agrees_with)),
        one.tag_id,
        against,
        one.against.size() == 1 ? "is" : "are",
        against));
  }
  if (!alone.empty()) {
    remarks.push_back(fmt::format(
        "Set aside, because the other tags agree with one another and not with {}: {} not where "
        "tags.yaml says. Measure {} again, or remove world_from_tag from tags.yaml to have {} "
        "estimated.",
        TagsOf(alone),
        alone.size() == 1 ? "it is" : "they are",
        alone.size() == 1 ? "it" : "them",
        alone.size() == 1 ? "it" : "them"));
  }
  return remarks;
}

}  // namespace fathom
