// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Plans that tell the rival causes of an ambiguous verdict on several DOFs apart.

#include "fathom/coupled/coupled_identification.h"
#include "fathom/coupled_planning/coupled_plan_text.h"
#include "fathom/coupled_planning/plan_coupled.h"
#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/coupled/entry_value.h"

#include <random>

#include "ambiguous_boat.h"
#include "boat_trial.h"
#include "drawn_vehicle.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

// What a first log of a weak cubic damping tells where a friction is assumed in its place, as a
// verdict that leaves both open may have it.
DrawnBoat FrictionAssumed() {
  std::mt19937 random(7001);
  DrawnBoat boat = {DrawnPlanarVehicle(&random), {}};
  SetValue(ParseFreeEntry("cubic_damping.sway"), 120.0, &boat.truth);
  DrawnLogOptions log;
  log.duration = 100.0;
  CoupledIdentificationOptions how;
  how.dofs = boat.truth.dofs;
  how.structure = StandardStructure::kCoriolis;
  how.also_free = {ParseFreeEntry("coulomb_friction.sway")};
  boat.fitted = IdentifyCoupled({LogFileOf(DrawnLog(boat.truth, log, &random))}, how).fitted;
  return boat;
}

// Played by the hidden truth in another simulator, the plan names it alone.
TEST(PlanOfRivals, LeavesTheLadderTheHiddenCauseAlone) {
  const DrawnBoat boat = FrictionAssumed();
  const FreeEntry assumed = ParseFreeEntry("coulomb_friction.sway");
  CoupledPlanRequest request = BoatRequest(boat, 60.0, 0.1);
  request.limits.force[1] = 80.0;
  request.limits.speed[0] = request.limits.speed[1] = 1.0;
  request.limits.room[0] = request.limits.room[1] = {-16.0, 16.0};
  request.rivals = {
      {assumed, ValueIn(boat.fitted.model, assumed), ParseFreeEntry("cubic_damping.sway")}};
  const CoupledPlan plan = PlanCoupledExperiment(request);
  ASSERT_TRUE(plan.IsUsable()) << plan.message;
  EXPECT_LE(plan.share_breaking, 0.05);
  ASSERT_EQ(plan.separations.size(), 2U);  // both ways
  for (const PlannedSeparation& pair : plan.separations) {
    EXPECT_TRUE(pair.IsDecided()) << pair.sigmas;
    EXPECT_GT(pair.sigmas, pair.sine);
  }
  const Ladder ladder = LadderOfPlayed(boat.truth, plan.command, plan.duration, 1);
  ASSERT_EQ(ladder.named.size(), 1U);
  EXPECT_EQ(NameOf(ladder.named[0].entry), "cubic_damping.sway");
  EXPECT_TRUE(ladder.named[0].not_told_apart.empty());
  EXPECT_THAT(CoupledPlanSentence(plan),
              HasSubstr("coulomb_friction.sway against cubic_damping.sway: decided at "));
}

}  // namespace
}  // namespace fathom
