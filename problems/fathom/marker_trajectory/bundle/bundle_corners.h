// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_model.h"
#include "fathom/camera/detection.h"
#include "fathom/marker_trajectory/bundle/bundle.h"
#include "fathom/marker_trajectory/bundle/corner_residual.h"

#include <cstddef>
#include <map>
#include <set>
#include <span>

#include <glog/logging.h>

namespace fathom {

// What a bundle adjustment is over. Borrows everything but the index.
struct Bundle {
  const CameraModel& camera;
  const MarkerMap& map;
  std::span<const Detection> detections;
  std::span<const AdjustedFrame> frames;
  const BundleAdjustmentOptions& options;
  std::map<int, int> index_of_free_id;  // places of the free markers, by rising id
};

inline std::map<int, int> IndexOf(const std::set<int>& free_ids) {
  std::map<int, int> index;
  for (const int id : free_ids) index.try_emplace(id, static_cast<int>(index.size()));
  return index;
}

// Calls visit(frame, index of the free marker or -1, residual) for every corner.
template <typename Visit>
void ForEachCorner(const Bundle& bundle, Visit visit) {
  for (std::size_t frame = 0; frame < bundle.frames.size(); ++frame) {
    CHECK(!bundle.frames[frame].detections.empty()) << "frame " << frame << " holds no detection";
    for (const int index : bundle.frames[frame].detections) {
      const Detection& detection = bundle.detections[index];
      const Marker* marker = bundle.map.Find(detection.tag_id);
      CHECK(marker != nullptr) << "tag " << detection.tag_id << " is not in the map";
      const auto free = bundle.index_of_free_id.find(detection.tag_id);
      const auto corners_in_tag = CornersInTag(marker->size);
      for (std::size_t i = 0; i < 4; ++i) {
        visit(frame,
              free == bundle.index_of_free_id.end() ? -1 : free->second,
              CornerResidual{
                  .camera = &bundle.camera,
                  .world_from_camera = &bundle.frames[frame].world_from_camera,
                  .world_from_tag = &marker->world_from_tag,
                  .corner_in_tag = corners_in_tag[i],
                  .pixel = detection.corners[i],
                  .corner_sigma = bundle.options.corner_sigma * bundle.frames[frame].noise_scale});
      }
    }
  }
}

}  // namespace fathom
