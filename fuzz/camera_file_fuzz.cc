// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as a camera's calibration; what is read must find the rays of its pixels, or say that
// there are none.

#include "fathom/base/input_error.h"
#include "fathom/camera/camera_file.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const auto camera = fathom::ParseCameraFile(
        "camera.yaml", std::string(reinterpret_cast<const char*>(data), size));
    for (const Eigen::Vector2d& pixel :
         {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(camera.width, camera.cy)}) {
      const auto ray = fathom::RayOf(camera, pixel);
      if (ray && !((fathom::Project(camera, *ray) - pixel).norm() < 1e-5)) std::abort();
    }
  } catch (const fathom::InputError&) {
  }
  return 0;
}
