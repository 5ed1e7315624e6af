// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace fathom {

// One grey value per pixel, row by row from the top left, without gaps between rows.
struct GrayImage {
  GrayImage() = default;
  GrayImage(int width_, int height_, std::uint8_t value = 0)
      : width(width_),
        height(height_),
        pixels(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), value) {}

  std::uint8_t& At(int u, int v) { return pixels[static_cast<std::size_t>(v) * width + u]; }
  std::uint8_t At(int u, int v) const { return pixels[static_cast<std::size_t>(v) * width + u]; }

  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;
};

}  // namespace fathom
