// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/geometry/stamped_pose.h"

#include <algorithm>
#include <cmath>

namespace fathom {

Stream PoseStreamOf(const std::vector<StampedPose>& poses) {
  Stream stream;
  stream.columns = {"x", "y", "z", "qx", "qy", "qz", "qw"};
  const bool has_covariance =
      std::all_of(poses.begin(), poses.end(), [](const StampedPose& stamped) {
        return stamped.covariance.diagonal().allFinite();
      });
  if (has_covariance) {
    stream.columns.insert(stream.columns.end(), {"sx", "sy", "sz", "sroll", "spitch", "syaw"});
  }
  stream.values.resize(stream.columns.size());
  for (const StampedPose& stamped : poses) {
    stream.time.push_back(stamped.time);
    for (int i = 0; i < 3; ++i) stream.values[i].push_back(stamped.pose.translation[i]);
    for (int i = 0; i < 4; ++i) stream.values[3 + i].push_back(stamped.pose.rotation.coeffs()[i]);
    if (!has_covariance) continue;
    for (int i = 0; i < 6; ++i) {
      stream.values[7 + i].push_back(std::sqrt(stamped.covariance(i, i)));
    }
  }
  return stream;
}

}  // namespace fathom
