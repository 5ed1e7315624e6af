// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/held_command.h"

#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(HeldCommand, HoldsEachValueUntilTheNextStampAndTheLastForEver) {
  const HeldCommand command{.time = {1.0, 2.5}, .value = {3.0, -4.0}};
  EXPECT_EQ(command.At(0.999), 0.0);
  EXPECT_EQ(command.At(1.0), 3.0);
  EXPECT_EQ(command.At(2.499), 3.0);
  EXPECT_EQ(command.At(2.5), -4.0);
  EXPECT_EQ(command.At(1e9), -4.0);
}

TEST(HeldCommand, GivesTheValuesAtRisingStampsInOneGo) {
  const HeldCommand command = {{0.0, 1.0, 2.0}, {5.0, 6.0, 7.0}};
  const std::vector<double> stamps = {-1.0, 0.0, 0.5, 0.5, 1.0, 9.0};
  EXPECT_EQ(command.At(stamps), (std::vector<double>{0.0, 5.0, 5.0, 5.0, 6.0, 7.0}));
  EXPECT_EQ(command.At(std::vector<double>{1.5}), std::vector<double>{6.0});
  EXPECT_TRUE(HeldCommand().At(std::vector<double>{}).empty());
}

TEST(HeldCommand, GivesWhatActsBetweenTwoTimes) {
  const HeldCommand command = {{0.0, 1.0, 2.0, 3.0}, {5.0, 6.0, 7.0, 8.0}};
  const HeldCommand part = command.Between(1.5, 3.0);
  EXPECT_EQ(part.time, (std::vector<double>{1.0, 2.0, 3.0}));
  EXPECT_EQ(part.value, (std::vector<double>{6.0, 7.0, 8.0}));
  EXPECT_EQ(command.Between(-1.0, 0.5).time, (std::vector<double>{0.0}));
  EXPECT_TRUE(command.Between(-2.0, -1.0).time.empty());
}

TEST(HeldCommand, IsZeroWhereNothingWasCommanded) { EXPECT_EQ(HeldCommand().At(5.0), 0.0); }

}  // namespace
}  // namespace fathom
