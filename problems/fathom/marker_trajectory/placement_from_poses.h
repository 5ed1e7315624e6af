// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_model.h"
#include "fathom/camera/detection.h"
#include "fathom/geometry/pose.h"

#include <optional>
#include <span>

namespace fathom {

// A camera whose pose is known, and the detection of a marker whose place is not.
struct PosedFrame {
  Pose world_from_camera;
  Detection detection;
  double noise_scale = 1.0;  // of its corners, as of ViewPose
};

// Where a marker of `size` [m] is: a start for the bundle adjustment, from frames whose poses other
// markers have told. Both poses of each square propose a place; the one that draws the corners of
// all frames best is taken, none of them counting more than an outlier. At most 24 frames, spread
// over the record, propose and judge. Nothing if half of them find none less than an outlier.
std::optional<Pose> PlaceMarkerFromPoses(const CameraModel& camera,
                                         double size,
                                         std::span<const PosedFrame> frames);

}  // namespace fathom
