// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/detect/image_noise.h"

#include "fathom/film/pixel_noise.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr int kWidth = 200;
constexpr int kHeight = 160;

// A slope with a bright square on it: smooth but for the square's edges.
std::vector<float> Scene() {
  std::vector<float> light;
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const bool is_square = u > 50 && u < 110 && v > 40 && v < 100;
      light.push_back(60.0F + 0.2F * u + 0.1F * v + (is_square ? 80.0F : 0.0F));
    }
  }
  return light;
}

TEST(NoiseOf, FindsTheNoiseUnderASceneWithEdges) {
  // The square root of the sum of noise and rounding (1/12). 8000 pixels, a quartile of them: 2 %
  // at one standard deviation, as neighbours share pixels.
  for (const double noise : {1.0, 3.0, 8.0}) {
    const GrayImage image = Expose(kWidth, kHeight, Scene(), noise, 0.0, 5);
    EXPECT_NEAR(NoiseOf(image), std::sqrt(noise * noise + 1.0 / 12.0), 0.08 * noise) << noise;
  }
}

TEST(NoiseOf, IsNothingWithoutNoise) {
  EXPECT_LT(NoiseOf(GrayImage(kWidth, kHeight, 90)), 0.1);
  EXPECT_EQ(NoiseOf(GrayImage(2, 2, 90)), 0.0);
}

TEST(Expose, AddsNoiseOfTheVarianceAsked) {
  // Light 100: variance 2^2 + 0.05 * 100 = 9, and 1/12 of rounding. 40000 pixels: the variance is
  // known to 0.7 %.
  const std::vector<float> light(40000, 100.0F);
  const GrayImage image = Expose(200, 200, light, 2.0, 0.05, 11);
  double sum = 0.0, square = 0.0;
  for (const auto pixel : image.pixels) {
    sum += pixel - 100.0;
    square += (pixel - 100.0) * (pixel - 100.0);
  }
  EXPECT_NEAR(sum / 40000.0, 0.0, 4.0 * 3.0 / 200.0);
  EXPECT_NEAR(square / 40000.0, 9.0 + 1.0 / 12.0, 0.03 * 9.0);
}

TEST(Expose, GivesTheSameNoiseForASeed) {
  const std::vector<float> light(400, 100.0F);
  EXPECT_EQ(Expose(20, 20, light, 2.0, 0.0, 3).pixels, Expose(20, 20, light, 2.0, 0.0, 3).pixels);
  EXPECT_NE(Expose(20, 20, light, 2.0, 0.0, 3).pixels, Expose(20, 20, light, 2.0, 0.0, 4).pixels);
}

TEST(Expose, StaysWithinTheGreyValues) {
  const GrayImage image = Expose(2, 1, std::vector<float>{-20.0F, 300.0F}, 0.0, 0.0, 1);
  EXPECT_EQ(image.At(0, 0), 0);
  EXPECT_EQ(image.At(1, 0), 255);
}

}  // namespace
}  // namespace fathom
