// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/images/gray_image.h"

#include <string>

namespace fathom {

// The image as the bytes of a PNG file, 8 bits of grey for each pixel.
std::string EncodePng(const GrayImage& image);

}  // namespace fathom
