// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/film/clipped_area.h"

#include <array>

#include <gtest/gtest.h>

namespace fathom {
namespace {

using Quadrangle = std::array<Eigen::Vector2d, 4>;

TEST(ClippedArea, IsTheWholeWhereNothingIsCut) {
  const Quadrangle square = {{{1.0, 1.0}, {3.0, 1.5}, {3.5, 4.0}, {0.5, 3.0}}};
  // Shoelace, by hand: x_i y_{i+1} - x_{i+1} y_i = -1.5, 6.75, 8.5, -2.5; half of 11.25.
  EXPECT_DOUBLE_EQ(AreaOf(square), 5.625);
  EXPECT_DOUBLE_EQ(AreaWithin(square, {0.0, 0.0}, {10.0, 10.0}), 5.625);
}

TEST(ClippedArea, CutsADiamondAtEachSide) {
  // Of side sqrt(2) around (0, 0).
  const Quadrangle diamond = {{{0.0, -1.0}, {1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}}};
  EXPECT_DOUBLE_EQ(AreaWithin(diamond, {0.0, 0.0}, {5.0, 5.0}), 0.5);
  EXPECT_DOUBLE_EQ(AreaWithin(diamond, {-5.0, -5.0}, {0.5, 5.0}), 2.0 - 0.25);
  // All four tips cut off: an octagon.
  EXPECT_DOUBLE_EQ(AreaWithin(diamond, {-0.5, -0.5}, {0.5, 0.5}), 1.0);
  EXPECT_DOUBLE_EQ(AreaWithin(diamond, {-0.75, -0.75}, {0.75, 0.75}), 2.0 - 4.0 * 0.0625);
}

TEST(ClippedArea, IsNothingBeside) {
  const Quadrangle square = {{{1.0, 1.0}, {2.0, 1.0}, {2.0, 2.0}, {1.0, 2.0}}};
  EXPECT_EQ(AreaWithin(square, {2.0, 0.0}, {3.0, 3.0}), 0.0);
  EXPECT_EQ(AreaWithin(square, {5.0, 0.0}, {6.0, 3.0}), 0.0);
}

TEST(ClippedArea, AddsUpOverCells) {
  const Quadrangle quadrangle = {{{0.3, 0.2}, {3.7, 0.9}, {3.1, 3.6}, {0.1, 2.8}}};
  for (const bool reversed : {false, true}) {
    Quadrangle turned = quadrangle;
    if (reversed) std::swap(turned[1], turned[3]);
    double sum = 0.0;
    for (int x = 0; x < 4; ++x) {
      for (int y = 0; y < 4; ++y) {
        sum += AreaWithin(turned, Eigen::Vector2d(x, y), Eigen::Vector2d(x + 1, y + 1));
      }
    }
    EXPECT_NEAR(sum, AreaOf(turned), 1e-12);
  }
}

}  // namespace
}  // namespace fathom
