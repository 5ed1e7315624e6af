// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/marker_trajectory/corner_noise.h"

#include "fathom/track/pose_refinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include <glog/logging.h>

namespace fathom {
namespace {

using CornersOfTag = std::array<Eigen::Vector2d, 4>;  // where drawn less where seen [px]

// By tag.
std::map<int, CornersOfTag> ResidualsOf(const CameraModel& camera,
                                        const MarkerMap& map,
                                        std::span<const Detection> detections,
                                        const TrackedView& view,
                                        const Pose& world_from_camera) {
  std::map<int, CornersOfTag> residuals;
  const Pose camera_from_world = world_from_camera.Inverse();
  for (const int index : view.detections) {
    const Marker* const marker = map.Find(detections[index].tag_id);
    CHECK(marker != nullptr) << "tag " << detections[index].tag_id << " is not in the map";
    const auto seen = SeenCornersOf(*marker, detections[index]);
    CornersOfTag& own = residuals[marker->id];
    for (std::size_t k = 0; k < 4; ++k) {
      const Eigen::Vector3d x_camera = camera_from_world * seen[k].x_world;
      own[k] = Project(camera, x_camera) - seen[k].pixel;
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
      const double scales =
          std::pow(views[i].pose.noise_scale, 2) + std::pow(views[i - 1].pose.noise_scale, 2);
      for (const auto& [id, corners] : now) {
        for (std::size_t k = 0; k < 4; ++k) {
          squares += (corners[k] - before.at(id)[k]).squaredNorm() / scales;
        }
      }
      dof += 8.0 * static_cast<double>(now.size()) - 6.0;
    }
    before = std::move(now);
  }
  return std::sqrt(squares / dof);
}

}  // namespace fathom
