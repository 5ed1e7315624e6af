// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_model.h"
#include "fathom/camera/detection.h"
#include "fathom/camera/marker_map.h"
#include "fathom/marker_trajectory/bundle/bundle.h"

#include <set>
#include <span>

namespace fathom {

// Poses of the camera, and of the markers in `free_ids`, that fit all corners best;
// docs/marker_trajectory.md (1):
//
//   minimise  sum over corners of rho(|pixel - Project(camera_from_world world_from_tag corner)|^2
//                                      / sigma^2)
//
// The other markers stay where the map has them, and hold the world: one at least must be seen
// together with the free ones, over any number of frames. Covariances are first-order, from the
// residuals' Jacobian at the end, each corner with its Huber weight; those of the poses include
// what is not known of the free markers. Poses are eliminated first: time and memory grow linearly
// with the frames.
//
// CHECKs that the frames hold detections of tags in the map. What the corners do not determine is
// said in the message, with is_usable false.
BundleAdjustmentSummary AdjustBundle(const CameraModel& camera,
                                     const MarkerMap& map,
                                     const std::set<int>& free_ids,
                                     std::span<const Detection> detections,
                                     std::span<const AdjustedFrame> frames,
                                     const BundleAdjustmentOptions& options = {});

}  // namespace fathom
