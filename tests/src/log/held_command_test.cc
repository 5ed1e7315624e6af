// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/held_command.h"

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

TEST(HeldCommand, IsZeroWhereNothingWasCommanded) { EXPECT_EQ(HeldCommand().At(5.0), 0.0); }

}  // namespace
}  // namespace fathom
