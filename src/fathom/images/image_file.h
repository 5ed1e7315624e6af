// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/images/gray_image.h"

#include <filesystem>
#include <string>

namespace fathom {

// The image in a file (JPEG, PNG, PGM, PPM, TIFF, BMP) in grey. A JPEG whose data are damaged
// or cut off is refused, where most decoders fill the rest with grey. Orientation tags are ignored:
// a calibration is of the pixels as the sensor has them.
//
// Throws InputError, naming the file, if it cannot be read or decoded, or has 16 bits per pixel.
GrayImage ReadImage(const std::filesystem::path& path);

// The same from memory; `name` stands for the file in messages.
GrayImage DecodeImage(const std::string& name, const std::string& bytes);

}  // namespace fathom
