// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/camera/camera_model.h"
#include "fathom/camera/detection.h"
#include "fathom/camera/marker_map.h"
#include "fathom/geometry/pose.h"
#include "fathom/log/held_command.h"

#include <vector>

namespace fathom {

// One unbroken stretch of a log as the camera saw it: the frames in which it saw a marker.
struct CameraSegment {
  std::vector<double> time;                        // of the frames [s], strictly increasing
  std::vector<std::vector<Detection>> detections;  // of each frame, at least one
  std::vector<Pose> world_from_body;               // of each frame, a first guess by PnP
  HeldCommand command;                             // of the excited DOF
};

// One or several logs of one vehicle moving along one DOF.
struct JointInput {
  Dof dof = Dof::kSurge;
  CameraModel camera;
  MarkerMap map;
  Pose body_from_camera;
  std::vector<CameraSegment> segments;
};

}  // namespace fathom
