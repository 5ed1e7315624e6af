// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_model.h"
#include "fathom/images/gray_image.h"

#include <array>
#include <optional>

#include <Eigen/Core>

namespace fathom {

// Corners of a square marker from its four sides, each followed through the image from where
// `corners` put it: distorted pixels, in any order around the square, right to about a pixel.
//
// A side is straight on the marker, thus straight among the rays and bent by the lens. Points along
// the bent side are moved across it to the centre of the squared gradient, interpolated between the
// pixels; a line is fitted to their rays, and neighbouring lines meet in the corners.
// docs/vision.md, "Detection", has what this changes against libapriltag's straight lines through
// whole pixels.
//
// Nothing if a side cannot be followed: off the image, without contrast, elsewhere than said, seen
// from beyond 90 degrees, or shorter than 20 px, where the blur of a side reaches the code beside
// it and libapriltag's corners are as good.
std::optional<std::array<Eigen::Vector2d, 4>> FollowSides(
    const GrayImage& image,
    const CameraModel& camera,
    double largest_angle,  // LargestAngle(camera) [rad]
    const std::array<Eigen::Vector2d, 4>& corners);

}  // namespace fathom
