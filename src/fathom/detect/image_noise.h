// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/images/gray_image.h"

namespace fathom {

// Standard deviation of the noise in an image [grey], from every fourth row. The second difference
// along both axes
//
//   [ 1 -2  1; -2  4 -2; 1 -2  1 ] * image
//
// takes away whatever is smooth and leaves 6 times the noise (Immerkaer, Computer Vision and Image
// Understanding 64, 1996). Of its sizes the lower quartile is taken, which edges and texture in up
// to three quarters of the image do not raise by much. 0 for an image of less than 3 x 3 pixels.
double NoiseOf(const GrayImage& image);

}  // namespace fathom
