// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/detect/detect_tags.h"

#include "fathom/base/input_error.h"
#include "fathom/base/plural.h"
#include "fathom/detect/edge_refinement.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// "tag16h5 13 (124 times), tag16h5 7 (3 times)": at most ten, the most frequent first.
std::string ListOf(const std::map<std::pair<std::string, int>, int>& count_of_tag) {
  constexpr std::size_t kMost = 10;
  std::vector<std::pair<int, std::string>> tags;
  for (const auto& [tag, count] : count_of_tag) {
    tags.emplace_back(
        count,
        fmt::format(
            "{} {} ({})", tag.first, tag.second, Plural(static_cast<std::size_t>(count), "time")));
  }
  std::stable_sort(
      tags.begin(), tags.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::string> shown;
  for (std::size_t i = 0; i < std::min(kMost, tags.size()); ++i) shown.push_back(tags[i].second);
  if (tags.size() > kMost) shown.push_back(fmt::format("... ({} tags in all)", tags.size()));
  return fmt::format("{}", fmt::join(shown, ", "));
}

}  // namespace

TagDetections DetectTags(FrameSource& frames,
                         const CameraModel& camera,
                         const MarkerMap& map,
                         const TagDetectorOptions& options,
                         const std::function<void(int done, int expected)>& progress) {
  const double largest_angle = LargestAngle(camera);
  TagDetector detector(map.Families(), options);
  TagDetections result;
  result.num_expected = frames.num_expected();
  for (ImageFrame frame; frames.Next(&frame);) {
    FrameDetections found =
        DetectionsAmong(detector.Detect(frame.image), map, options.max_hamming, frame.time);
    if (options.refine_edges) {
      for (Detection& detection : found.detections) {
        const auto corners = FollowSides(frame.image, camera, largest_angle, detection.corners);
        if (corners) {
          detection.corners = *corners;
        } else {
          ++result.num_not_followed;
        }
      }
    }
    result.frame_times.push_back(frame.time);
    if (found.detections.empty()) {
      auto& times =
          found.unused.empty() ? result.times_without_tags : result.times_with_unused_only;
      times.push_back(frame.time);
    }
    result.detections.insert(
        result.detections.end(), found.detections.begin(), found.detections.end());
    result.unused.insert(result.unused.end(), found.unused.begin(), found.unused.end());
    if (progress) progress(static_cast<int>(result.frame_times.size()), result.num_expected);
  }
  result.num_unreadable = frames.num_unreadable();
  result.unreadable = frames.unreadable();
  result.remarks = frames.remarks();
  if (result.frame_times.empty()) {
    throw InputError(
        fmt::format("{}: none of {} frames can be read: {}",
                    frames.name(),
                    result.num_expected,
                    result.unreadable.empty() ? "there are none." : result.unreadable.front()));
  }
  return result;
}

std::vector<std::string> RemarksOn(const TagDetections& found, const MarkerMap& map) {
  std::vector<std::string> remarks = found.remarks;
  if (found.num_unreadable > 0) {
    remarks.push_back(
        fmt::format("{} of {} frames cannot be read.", found.num_unreadable, found.num_expected));
  }
  if (!found.times_without_tags.empty()) {
    remarks.push_back(fmt::format("{} of {} frames show no tag of {}.",
                                  found.times_without_tags.size(),
                                  found.frame_times.size(),
                                  fmt::join(map.Families(), ", ")));
  }
  if (!found.times_with_unused_only.empty()) {
    remarks.push_back(
        fmt::format("{} of {} frames show only tags that are not used, the first at t = {}.",
                    found.times_with_unused_only.size(),
                    found.frame_times.size(),
                    found.times_with_unused_only.front()));
  }
  std::map<SightingFault, std::map<std::pair<std::string, int>, int>> counts;
  for (const UnusedSighting& it : found.unused) {
    ++counts[it.fault][{it.sighting.family, it.sighting.tag_id}];
  }
  for (const auto& [fault, count_of_tag] : counts) {
    int num = 0;
    for (const auto& [tag, count] : count_of_tag) num += count;
    remarks.push_back(fmt::format("Not used: {} of a tag that {}: {}.",
                                  Plural(static_cast<std::size_t>(num), "sighting"),
                                  Describe(fault),
                                  ListOf(count_of_tag)));
  }
  if (found.num_not_followed > 0) {
    remarks.push_back(fmt::format(
        "{} of {} detections keep the less accurate corners of libapriltag, because their sides "
        "could not be followed.",
        found.num_not_followed,
        found.detections.size()));
  }
  return remarks;
}

}  // namespace fathom
