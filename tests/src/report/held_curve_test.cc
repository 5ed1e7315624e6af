// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/held_curve.h"

#include <gmock/gmock.h>

namespace fathom {
namespace {

using testing::ElementsAre;
using testing::IsNan;

TEST(HeldCurve, HoldsEachValueUntilTheNextAndBreaksBehind) {
  TimePanel panel = HeldCurvePanel("commanded force", "N");
  AppendHeldCurve({1.0, 2.0, 4.0, 9.0}, {10.0, 20.0, 40.0, 90.0}, {2.5, 5.0}, 100.0, &panel);
  EXPECT_THAT(panel.time, ElementsAre(102.5, 104.0, 105.0, 105.0));
  EXPECT_THAT(panel.responses.at(0).values, ElementsAre(20.0, 40.0, 40.0, IsNan()));
}

TEST(HeldCurve, IsZeroBeforeTheFirstStampAndHoldsTheLastForEver) {
  TimePanel panel = HeldCurvePanel("commanded force", "N");
  AppendHeldCurve({1.0}, {7.0}, {0.0, 3.0}, 0.0, &panel);
  AppendHeldCurve({1.0}, {7.0}, {5.0, 6.0}, 0.0, &panel);
  EXPECT_THAT(panel.time, ElementsAre(0.0, 1.0, 3.0, 3.0, 5.0, 6.0, 6.0));
  EXPECT_THAT(panel.responses.at(0).values, ElementsAre(0.0, 7.0, 7.0, IsNan(), 7.0, 7.0, IsNan()));
}

}  // namespace
}  // namespace fathom
