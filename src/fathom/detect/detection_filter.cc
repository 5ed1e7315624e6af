// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/detect/detection_filter.h"

#include <algorithm>
#include <optional>

namespace fathom {
namespace {

// Twice the signed area at one corner; below 0 where AprilTag's order turns, with v down.
double TurnAt(const std::array<Eigen::Vector2d, 4>& corners, int i) {
  const Eigen::Vector2d in = corners[i] - corners[(i + 3) % 4];
  const Eigen::Vector2d out = corners[(i + 1) % 4] - corners[i];
  return in.x() * out.y() - in.y() * out.x();
}

bool IsQuadrangle(const std::array<Eigen::Vector2d, 4>& corners) {
  for (int i = 0; i < 4; ++i) {
    if (!(TurnAt(corners, i) < 0.0)) return false;
  }
  return true;
}

bool IsSame(const TagSighting& a, const TagSighting& b) {
  return a.tag_id == b.tag_id && a.family == b.family;
}

std::optional<SightingFault> FaultOf(const TagSighting& sighting,
                                     std::span<const TagSighting> all,
                                     const MarkerMap& map,
                                     int max_hamming) {
  if (sighting.hamming > max_hamming) return SightingFault::kWrongBits;
  const Marker* marker = map.Find(sighting.tag_id);
  if (marker == nullptr || marker->family != sighting.family) return SightingFault::kNotInMap;
  const auto seen = std::count_if(all.begin(), all.end(), [&](const TagSighting& other) {
    return IsSame(sighting, other) && other.hamming <= max_hamming;
  });
  if (seen > 1) return SightingFault::kSeveralSeen;
  if (!IsQuadrangle(sighting.corners)) return SightingFault::kDegenerate;
  return std::nullopt;
}

}  // namespace

std::string_view Describe(SightingFault fault) {
  switch (fault) {
    case SightingFault::kWrongBits:
      return "has wrong bits in its code";
    case SightingFault::kNotInMap:
      return "is not in the map";
    case SightingFault::kSeveralSeen:
      return "is in the frame more than once";
    case SightingFault::kDegenerate:
      return "has corners that are no convex quadrangle";
  }
  return "";
}

FrameDetections DetectionsAmong(std::span<const TagSighting> sightings,
                                const MarkerMap& map,
                                int max_hamming,
                                double time) {
  FrameDetections result;
  for (const TagSighting& sighting : sightings) {
    if (const auto fault = FaultOf(sighting, sightings, map, max_hamming)) {
      result.unused.push_back({.time = time, .sighting = sighting, .fault = *fault});
      continue;
    }
    Detection detection;
    detection.time = time;
    detection.tag_id = sighting.tag_id;
    detection.corners = sighting.corners;
    result.detections.push_back(detection);
  }
  std::sort(result.detections.begin(),
            result.detections.end(),
            [](const Detection& a, const Detection& b) { return a.tag_id < b.tag_id; });
  return result;
}

}  // namespace fathom
