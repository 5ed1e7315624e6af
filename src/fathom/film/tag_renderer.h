// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_model.h"
#include "fathom/camera/marker_map.h"
#include "fathom/film/water_view.h"
#include "fathom/geometry/pose.h"
#include "fathom/images/gray_image.h"

#include <cstdint>
#include <memory>
#include <span>

namespace fathom {

// Draws what a camera under water sees of markers on a wall: distortion, the water, motion during
// the exposure, vignetting, blur and noise. For tests and synthetic logs, so that a detector meets
// images whose corners are known.
//
// A pixel is the mean light over its area, to the extent that straight lines stay straight within
// it. The back of a marker is not seen; a nearer marker hides one behind it.
class TagRenderer {
 public:
  // Throws InputError if a family or tag is not known, or the view breaks a rule. Holds 12 bytes
  // per pixel of the camera.
  TagRenderer(const CameraModel& camera, const MarkerMap& map, const WaterView& view = {});
  ~TagRenderer();
  TagRenderer(TagRenderer&&) noexcept;
  TagRenderer& operator=(TagRenderer&&) noexcept;

  // The image of an exposure during which the camera passes through these poses, each for the same
  // time; a single one for a still camera. The same seed gives the same noise.
  GrayImage Render(std::span<const Pose> world_from_camera, std::uint64_t seed) const;

 private:
  struct Implementation;

  std::unique_ptr<const Implementation> implementation_;
};

}  // namespace fathom
