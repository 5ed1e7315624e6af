// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/film/pixel_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>

#include <glog/logging.h>

namespace fathom {
namespace {

constexpr std::size_t kNumQuantiles = 4096;

// The x below which a normal number of mean 0 and standard deviation 1 is with this probability.
double NormalQuantile(double probability) {
  double below = -8.0, above = 8.0;
  for (int i = 0; i < 60; ++i) {
    const double x = 0.5 * (below + above);
    const double is_below = 0.5 * std::erfc(-x / std::numbers::sqrt2);
    (is_below < probability ? below : above) = x;
  }
  return 0.5 * (below + above);
}

std::array<float, kNumQuantiles> NormalQuantiles() {
  std::array<float, kNumQuantiles> table;
  double square = 0.0;
  for (std::size_t i = 0; i < kNumQuantiles; ++i) {
    table[i] = static_cast<float>(NormalQuantile((i + 0.5) / kNumQuantiles));
    square += table[i] * table[i];
  }
  // Cut tails take a little of the variance.
  for (float& x : table) x /= static_cast<float>(std::sqrt(square / kNumQuantiles));
  return table;
}

// Numbers drawn from the table, five of each 64 bits.
class NormalNumbers {
 public:
  explicit NormalNumbers(std::uint64_t seed) : bits_(seed) {}

  float Next() {
    if (num_left_ == 0) {
      current_ = bits_();
      num_left_ = 5;
    }
    --num_left_;
    const float number = Table()[current_ % kNumQuantiles];
    current_ /= kNumQuantiles;
    return number;
  }

 private:
  static const std::array<float, kNumQuantiles>& Table() {
    static const std::array<float, kNumQuantiles> table = NormalQuantiles();
    return table;
  }

  std::mt19937_64 bits_;
  std::uint64_t current_ = 0;
  int num_left_ = 0;
};

}  // namespace

GrayImage Expose(int width,
                 int height,
                 std::span<const float> light,
                 double noise,
                 double shot_noise,
                 std::uint64_t seed) {
  GrayImage image(width, height);
  CHECK_EQ(light.size(), image.pixels.size());
  const bool is_noisy = noise > 0.0 || shot_noise > 0.0;
  const float constant = static_cast<float>(noise * noise);
  const float slope = static_cast<float>(shot_noise);
  NormalNumbers normal(seed);
  for (std::size_t i = 0; i < light.size(); ++i) {
    float value = light[i];
    if (is_noisy) {
      value += std::sqrt(std::max(0.0F, constant + slope * light[i])) * normal.Next();
    }
    image.pixels[i] = static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0F, 255.0F)));
  }
  return image;
}

}  // namespace fathom
