// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/corner_noise.h"

#include "fathom/marker_trajectory/corner_residual.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

#include <glog/logging.h>

namespace fathom {
namespace {

using CornersOfTag = std::array<Eigen::Vector2d, 4>;  // where drawn less where seen [px]

// By tag. NaN for a point behind the camera.
std::map<int, CornersOfTag> ResidualsOf(const CameraModel& camera,
                                        const MarkerMap& map,
                                        std::span<const Detection> detections,
                                        const TrackedView& view,
                                        const Pose& world_from_camera) {
  std::map<int, CornersOfTag> residuals;
  const PoseIncrement no_step = PoseIncrement::Zero();
  for (const int index : view.detections) {
    const Detection& detection = detections[index];
    const Marker* const marker = map.Find(detection.tag_id);
    CHECK(marker != nullptr) << "tag " << detection.tag_id << " is not in the map";
    const auto corners_in_tag = CornersInTag(marker->size);
    CornersOfTag& own = residuals[detection.tag_id];
    for (std::size_t i = 0; i < 4; ++i) {
      const CornerResidual residual = {.camera = &camera,
                                       .world_from_camera = &world_from_camera,
                                       .world_from_tag = &marker->world_from_tag,
                                       .corner_in_tag = corners_in_tag[i],
                                       .pixel = detection.corners[i],
                                       .corner_sigma = 1.0};
      own[i].setConstant(std::numeric_limits<double>::quiet_NaN());
      residual(no_step.data(), own[i].data());
    }
  }
  return residuals;
}

}  // namespace

double CornerNoise(const CameraModel& camera,
                   const MarkerMap& map,
                   std::span<const Detection> detections,
                   std::span<const TrackedView> views,
                   std::span<const StampedPose> track) {
  CHECK_EQ(views.size(), track.size());
  constexpr double kLongestStep = 1.0;  // [s]
  double squares = 0.0, dof = 0.0;
  std::map<int, CornersOfTag> before;
  for (std::size_t i = 0; i < track.size(); ++i) {
    std::map<int, CornersOfTag> now = ResidualsOf(camera, map, detections, views[i], track[i].pose);
    const auto is_same_tag = [](const auto& a, const auto& b) { return a.first == b.first; };
    const bool is_next = i > 0 && track[i].time - track[i - 1].time <= kLongestStep;
    if (is_next && std::equal(now.begin(), now.end(), before.begin(), before.end(), is_same_tag)) {
      for (const auto& [id, corners] : now) {
        for (std::size_t k = 0; k < 4; ++k) {
          squares += (corners[k] - before.at(id)[k]).squaredNorm() / 2.0;
        }
      }
      dof += 8.0 * static_cast<double>(now.size()) - 6.0;
    }
    before = std::move(now);
  }
  return std::sqrt(squares / dof);
}

}  // namespace fathom
