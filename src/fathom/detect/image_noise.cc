// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/detect/image_noise.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace fathom {

double NoiseOf(const GrayImage& image) {
  constexpr int kRowStep = 4;
  constexpr double kGain = 6.0;               // of the mask for white noise
  constexpr double kLowerQuartile = 0.31864;  // of |x|, x normal with standard deviation 1
  std::array<int, 16 * 255 + 1> num_of_size{};
  int num = 0;
  for (int v = 1; v + 1 < image.height; v += kRowStep) {
    const std::uint8_t* above = &image.pixels[static_cast<std::size_t>(v - 1) * image.width];
    const std::uint8_t* here = above + image.width;
    const std::uint8_t* below = here + image.width;
    for (int u = 1; u + 1 < image.width; ++u) {
      const int value = above[u - 1] - 2 * above[u] + above[u + 1] - 2 * here[u - 1] + 4 * here[u] -
                        2 * here[u + 1] + below[u - 1] - 2 * below[u] + below[u + 1];
      ++num_of_size[std::abs(value)];
      ++num;
    }
  }
  // Within the whole number that holds the quartile, evenly.
  const double rank = 0.25 * num;
  double below = 0.0;
  for (std::size_t size = 0; size < num_of_size.size(); ++size) {
    const double here = num_of_size[size];
    if (here > 0.0 && below + here >= rank) {
      // A size n stands for n - 1/2 to n + 1/2, 0 for 0 to 1/2.
      const double width = size == 0 ? 0.5 : 1.0;
      const double low = size == 0 ? 0.0 : static_cast<double>(size) - 0.5;
      return (low + width * (rank - below) / here) / (kGain * kLowerQuartile);
    }
    below += here;
  }
  return 0.0;
}

}  // namespace fathom
