// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_rig.h"
#include "fathom/camera/detection.h"
#include "fathom/film/water_view.h"
#include "fathom/geometry/stamped_pose.h"
#include "fathom/log/log.h"
#include "fathom/synthesize/experiment/experiment.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace fathom {

// How a synthetic experiment is filmed; docs/synthesize.md ("Camera logs").
struct Film {
  // What the log says of camera, markers and mount, and the files it is copied from.
  CameraRig rig;
  std::filesystem::path camera_file, tags_file, mount_file;

  MarkerMap true_map;     // how the markers really are; those of the rig if nothing else is said
  Sampling sampling;      // of the frames
  double exposure = 0.0;  // [s]; 0: none

  // The DOFs that are not driven are held: they move by sums of slow sines of these standard
  // deviations.
  double hold_position = 0.0;  // [m]
  double hold_angle = 0.0;     // [rad]

  // Detections without images.
  double corner_sigma = 0.3;         // of a corner's u and v [px]
  double outlier_probability = 0.0;  // that a detection is one
  double outlier_size = 20.0;        // standard deviation of what is added to all its corners [px]

  WaterView view;  // of rendered images
};

// The poses of the body at the stamps of `shown` (a pose stream: world_from_body), with the motion
// of the DOFs that are held but not driven.
std::vector<StampedPose> HeldPoses(const Stream& shown,
                                   const std::vector<Dof>& driven,
                                   const Film& film,
                                   std::uint64_t seed);

// Corners with noise and outliers, of the markers that are in view.
std::vector<Detection> FilmCorners(std::span<const StampedPose> world_from_body,
                                   const Film& film,
                                   std::uint64_t seed);

// The camera's poses during the exposure of a frame, whose stamp is in its middle: from the speed
// between the frames before and after.
std::vector<Pose> PosesDuringExposure(std::span<const StampedPose> world_from_body,
                                      std::size_t frame,
                                      const Film& film);

}  // namespace fathom
