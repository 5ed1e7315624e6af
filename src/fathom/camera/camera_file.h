// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/camera/camera_model.h"

#include <filesystem>
#include <string>
#include <vector>

namespace fathom {

// Reads a camera's calibration, either of (docs/file_formats.md):
//
//   ROS camera_info    image_width, image_height, camera_matrix, distortion_model (plumb_bob,
//                      rational_polynomial, equidistant or fisheye, none), distortion_coefficients
//   Kalibr camchain    cam0: camera_model pinhole, intrinsics, distortion_model (radtan,
//                      equidistant, none), distortion_coeffs, resolution; one camera
//
// Throws InputError, naming file, line and key, for whatever breaks the format, for a skewed camera
// matrix and for an optical centre that is not on the image.
//
// `remarks`, if given, gets a sentence for a clock offset in the file: none is applied.
CameraModel ReadCameraFile(const std::filesystem::path& path,
                           std::vector<std::string>* remarks = nullptr);

// The same from memory; `name` stands for the file in messages.
CameraModel ParseCameraFile(const std::string& name,
                            const std::string& text,
                            std::vector<std::string>* remarks = nullptr);

// Throws InputError if images of width x height are not those that the camera was calibrated with.
// `frames` names them in the message, `camera_file` the calibration.
void RequireFrameSize(const CameraModel& camera,
                      const std::string& camera_file,
                      const std::string& frames,
                      int width,
                      int height);

}  // namespace fathom
