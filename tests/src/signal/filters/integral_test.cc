// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/signal/filters/integral.h"

#include <vector>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;

TEST(Integral, IsTheTrapezoidalRule) {
  EXPECT_THAT(Integral(std::vector<double>{1.0, 1.5, 3.5}, std::vector<double>{2.0, 4.0, -1.0}),
              ElementsAre(0.0, 1.5, 4.5));
}

// 3 until 0.7, then -2 until 2.4, then 5. Stamps before, between and at the changes:
//   at 0.5: 1.5 and 3 * 0.5^2 / 2 = 0.375
//   at 2.4: 2.1 - 3.4 = -1.3; at 0.7 the second is 0.735, then 2.1 * 1.7 - 2 * 1.7^2 / 2 = 0.68
//   more at 3.0: -1.3 + 3 = 1.7; 1.415 - 1.3 * 0.6 + 5 * 0.6^2 / 2 = 1.535
TEST(Integral, OfAHeldCommandIsExactBetweenTheStamps) {
  const HeldCommand command = {{-1.0, 0.7, 2.4}, {3.0, -2.0, 5.0}};
  const auto integrals = IntegralsOf(command, std::vector<double>{0.0, 0.5, 2.4, 3.0});
  const auto near = [](double x) { return DoubleNear(x, 1e-12); };
  EXPECT_THAT(integrals.once, ElementsAre(near(0.0), near(1.5), near(-1.3), near(1.7)));
  EXPECT_THAT(integrals.twice, ElementsAre(near(0.0), near(0.375), near(1.415), near(1.535)));
}

TEST(Integral, OfACommandIsZeroBeforeItsFirstStamp) {
  const HeldCommand command = {{1.0}, {4.0}};
  const auto integrals = IntegralsOf(command, std::vector<double>{0.0, 2.0});
  EXPECT_THAT(integrals.once, ElementsAre(0.0, DoubleNear(4.0, 1e-12)));
  EXPECT_THAT(integrals.twice, ElementsAre(0.0, DoubleNear(2.0, 1e-12)));
}

}  // namespace
}  // namespace fathom
