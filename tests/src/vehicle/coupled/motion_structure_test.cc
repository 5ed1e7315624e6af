// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/coupled/motion_structure.h"

#include <vector>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using testing::ElementsAre;
using testing::SizeIs;
using Block = std::vector<Dof>;

const std::vector<Dof> kPlane = {Dof::kSurge, Dof::kSway, Dof::kYaw};

TEST(BlocksOf, ADiagonalPlaneAreThree) {
  EXPECT_THAT(BlocksOf(StructureOf(StandardStructure::kDiagonal, kPlane)),
              ElementsAre(Block{Dof::kSurge}, Block{Dof::kSway}, Block{Dof::kYaw}));
}

// With C(nu) a diagonal inertia already couples u, v and r.
TEST(BlocksOf, TheSamePlaneWithCoriolisForcesAreOne) {
  EXPECT_THAT(BlocksOf(StructureOf(StandardStructure::kCoriolis, kPlane)), ElementsAre(kPlane));
}

TEST(BlocksOf, AnEntryOffTheDiagonalJoinsTwo) {
  MotionStructure structure = StructureOf(StandardStructure::kDiagonal, kPlane);
  structure.entries.push_back(LinearDampingEntry(Dof::kSway, Dof::kYaw));
  EXPECT_THAT(BlocksOf(structure), ElementsAre(Block{Dof::kSurge}, Block{Dof::kSway, Dof::kYaw}));
}

// What rolls or pitches lifts by another part of its buoyancy.
TEST(BlocksOf, ATiltJoinsHeaveByItsBuoyancy) {
  const std::vector<Dof> dofs = {Dof::kHeave, Dof::kPitch};
  MotionStructure structure = StructureOf(StandardStructure::kDiagonal, dofs);
  EXPECT_THAT(BlocksOf(structure), ElementsAre(dofs));
  std::erase(structure.entries, NetBuoyancyEntry());
  EXPECT_THAT(BlocksOf(structure), SizeIs(2));
}

// A vehicle whose port side mirrors its starboard side: sway, roll and yaw, and surge, heave,
// pitch.
TEST(StructureOf, FreesOffTheDiagonalWhatAMirrorAllows) {
  const std::vector<Dof> all(kAllDofs.begin(), kAllDofs.end());
  const auto num_entries = [&](StandardStructure standard) {
    return StructureOf(standard, all).entries.size();
  };
  EXPECT_EQ(num_entries(StandardStructure::kDiagonal), 6u * 4u + 2u);
  EXPECT_EQ(num_entries(StandardStructure::kCoriolis), 26u);
  EXPECT_EQ(num_entries(StandardStructure::kSymmetric), 26u + 6u);
  EXPECT_EQ(num_entries(StandardStructure::kFull), 32u + 12u);
}

TEST(StandardStructures, HaveNames) {
  EXPECT_EQ(StandardStructureFromName("symmetric"), StandardStructure::kSymmetric);
  EXPECT_EQ(Name(StandardStructure::kFull), "full");
  EXPECT_FALSE(StandardStructureFromName("auto"));
}

}  // namespace
}  // namespace fathom
