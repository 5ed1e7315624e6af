// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/structure_ladder.h"
#include "fathom/vehicle/coupled/entry_name.h"

#include <array>
#include <random>
#include <string>
#include <vector>

#include "drawn_thrusters.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr std::array<double, 4> kSound = {1.0, 1.0, 1.0, 1.0};

// A vehicle whose thrusters push as `gain` says, 100 s of steps at 10 Hz.
Ladder LadderOfThrusters(unsigned seed, const std::array<double, 4>& gain, bool holds_heading) {
  std::mt19937 random(seed);
  const CoupledModel truth = DrawnPlanarVehicle(&random);
  DrawnLogOptions options;
  options.duration = 100.0;
  CoupledLogs logs;
  logs.data = {DrawnThrusterLog(truth, gain, holds_heading, options, &random)};
  EntrySearchOptions search;
  for (const CommandedThruster& thruster : FourThrusters()) {
    search.thrusters.push_back(thruster.name);
  }
  return ClimbLadder(logs, truth.dofs, search);
}

std::vector<std::string> EntriesNamedIn(const Ladder& ladder) {
  std::vector<std::string> names;
  for (const NamedEntry& named : ladder.named) names.push_back(NameOf(named.entry));
  return names;
}

TEST(ClimbLadder, NamesAWeakThruster) {
  const Ladder ladder = LadderOfThrusters(21, {1.0, 0.8, 1.0, 1.0}, false);
  ASSERT_THAT(EntriesNamedIn(ladder), ElementsAre("thrust_gain.starboard"));
  EXPECT_NEAR(ladder.named.front().value, 0.8, 0.03);
}

TEST(ClimbLadder, NamesADeadThrusterUnderHeadingHold) {
  const Ladder ladder = LadderOfThrusters(22, {1.0, 1.0, 0.0, 1.0}, true);
  ASSERT_THAT(EntriesNamedIn(ladder), ElementsAre("thrust_gain.bow"));
  EXPECT_NEAR(ladder.named.front().value, 0.0, 0.03);
}

TEST(ClimbLadder, NamesNoSoundThruster) {
  EXPECT_THAT(EntriesNamedIn(LadderOfThrusters(23, kSound, true)), IsEmpty());
}

}  // namespace
}  // namespace fathom
