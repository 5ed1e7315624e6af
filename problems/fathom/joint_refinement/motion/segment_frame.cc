// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/joint_refinement/motion/segment_frame.h"

#include "fathom/signal/filters/mean_attitude.h"

#include <vector>

namespace fathom {

Pose SegmentFrameOf(Dof dof, std::span<const Pose> world_from_body) {
  std::vector<Eigen::Quaterniond> attitudes;
  for (const Pose& pose : world_from_body) attitudes.push_back(pose.rotation);
  return {MeanAttitude(dof, attitudes), Eigen::Vector3d::Zero()};
}

MarkerMap MapIn(const Pose& frame_from_world, const MarkerMap& map) {
  MarkerMap turned = map;
  for (Marker& marker : turned.markers) {
    marker.world_from_tag = frame_from_world * marker.world_from_tag;
  }
  return turned;
}

}  // namespace fathom
