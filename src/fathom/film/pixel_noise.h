// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/images/gray_image.h"

#include <cstdint>
#include <span>

namespace fathom {

// Light as a sensor reads it: rounded to whole grey values from 0 to 255, with normal noise of
// variance noise^2 + shot_noise * light. The same seed gives the same image on every platform; no
// noise is beyond 3.7 standard deviations.
GrayImage Expose(int width,
                 int height,
                 std::span<const float> light,
                 double noise,
                 double shot_noise,
                 std::uint64_t seed);

}  // namespace fathom
