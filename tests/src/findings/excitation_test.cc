// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/excitation.h"

#include "fathom/base/random_stream.h"

#include <cmath>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

// 600 s at 5 Hz, driven from 100 to 160 s and from 400 to 500 s.
struct Dive {
  HeldCommand command;
  Segment segment;
};

Dive LongDive(bool is_driven) {
  RandomStream noise(1, "noise");
  Dive dive;
  double v = 0.0;
  for (int k = 0; k < 3000; ++k) {
    const double t = 0.2 * k;
    const bool is_on = is_driven && ((t >= 100.0 && t < 160.0) || (t >= 400.0 && t < 500.0));
    const double force = is_on ? (std::fmod(t, 12.0) < 6.0 ? 20.0 : -20.0) : 0.0;
    dive.command.time.push_back(t);
    dive.command.value.push_back(force);
    dive.segment.time.push_back(t);
    dive.segment.velocity.push_back(v + 0.005 * noise.Normal());
    v += 0.2 * (force - 30.0 * v * std::abs(v) - 5.0 * v) / 40.0;
  }
  return dive;
}

TEST(Excitation, FindsTheDrivenPartsOfALongDive) {
  const Dive dive = LongDive(true);
  const Excitation found = ExcitationOf(dive.command, {&dive.segment, 1});
  ASSERT_THAT(found.stretches, SizeIs(2));
  // Blocks are of 5 s, and each takes its neighbours along.
  EXPECT_NEAR(found.stretches[0].from, 100.0, 10.0);
  EXPECT_NEAR(found.stretches[0].to, 160.0, 10.0);
  EXPECT_NEAR(found.stretches[1].from, 400.0, 10.0);
  EXPECT_NEAR(found.stretches[1].to, 500.0, 10.0);
  EXPECT_NEAR(found.duration, 599.8, 1e-9);
}

TEST(Excitation, HoldsOutTheLastQuarterOfIt) {
  const Dive dive = LongDive(true);
  const Excitation found = ExcitationOf(dive.command, {&dive.segment, 1});
  ASSERT_TRUE(found.held_out);
  EXPECT_GT(found.held_out->from, 400.0);
  EXPECT_NEAR(found.held_out->to - found.held_out->from, 0.25 * found.excited, 1e-9);
}

TEST(Excitation, IsNoneAtRest) {
  const Dive dive = LongDive(false);
  const Excitation found = ExcitationOf(dive.command, {&dive.segment, 1});
  EXPECT_THAT(found.stretches, IsEmpty());
  EXPECT_FALSE(found.held_out);
}

}  // namespace
}  // namespace fathom
