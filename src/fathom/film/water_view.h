// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

namespace fathom {

// How markers on a wall look through water and a lens; docs/vision.md ("Rendered images"). Light is
// in grey values, linear, 0 to 255. A surface of brightness J at the distance d [m] is seen as
//
//   I = J exp(-c d) + B (1 - exp(-c d))                       docs/vision.md (9)
//
// the first term its own light, the second what the water scatters into the line of sight.
struct WaterView {
  double white = 200.0;  // J of a marker's white
  double black = 15.0;   // J of its black
  double wall = 110.0;   // J of the wall, the plane of the first marker

  double attenuation = 0.0;     // c [1/m], at least 0
  double veiling_light = 60.0;  // B

  // Share of the light that is missing in the corners of the image, as the square of the distance
  // from the optical centre; 0 to 1.
  double vignetting = 0.0;

  // Point spread of lens and water, a normal curve of this standard deviation [px]; 0: none.
  double blur = 0.7;

  // The variance of a pixel of grey value g is noise^2 + shot_noise g; both at least 0.
  double noise = 1.0;       // [grey]
  double shot_noise = 0.0;  // [grey]

  // Every broken rule; empty if there is none.
  std::vector<std::string> Problems() const;
};

}  // namespace fathom
