// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>

#include <Eigen/Core>

namespace fathom {

// One marker in one frame.
struct Detection {
  double time = 0.0;  // of the frame, log time [s]
  int tag_id = 0;

  // Distorted pixels, the centre of the first pixel at (0, 0), in the order of AprilTag 3:
  // bottom-left, bottom-right, top-right, top-left of the upright tag.
  std::array<Eigen::Vector2d, 4> corners = {Eigen::Vector2d::Zero(),
                                            Eigen::Vector2d::Zero(),
                                            Eigen::Vector2d::Zero(),
                                            Eigen::Vector2d::Zero()};
};

}  // namespace fathom
