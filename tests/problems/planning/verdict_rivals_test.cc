// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/verdict_rivals.h"

#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/coupled/entry_value.h"

#include <string>

#include "error_from.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

FittedCoupledModel SwayModel() {
  FittedCoupledModel fitted;
  fitted.model.dofs = {Dof::kSurge, Dof::kSway};
  fitted.entries = {ParseFreeEntry("cubic_damping.sway"), ThrustGainEntry("port")};
  SetValue(fitted.entries[0], 90.0, &fitted.model);
  return fitted;
}

std::string VerdictText(const std::string& verdict,
                        const std::string& entry,
                        const std::string& alternatives) {
  return R"({"verdict": ")" + verdict + R"(", "causes": [{"entry": ")" + entry +
         R"(", "alternatives": [)" + alternatives + "]}]}";
}

VerdictRivals RivalsOf(const std::string& text) {
  return ReadVerdictRivals("boat.json", text, SwayModel());
}

TEST(VerdictRivals, AreTheAlternativesOfAnAmbiguousCause) {
  const VerdictRivals open = RivalsOf(
      VerdictText("ambiguous", "cubic_damping.sway", R"("coulomb_friction.sway", "thruster_lag")"));
  ASSERT_EQ(open.pairs.size(), 2u);
  EXPECT_EQ(NameOf(open.pairs[0].named), "cubic_damping.sway");
  EXPECT_EQ(open.pairs[0].value, 90.0);
  EXPECT_EQ(NameOf(open.pairs[0].rival), "coulomb_friction.sway");
  EXPECT_EQ(open.pairs[1].rival, ThrusterLagEntry());
  EXPECT_THAT(open.left_out, IsEmpty());
}

TEST(VerdictRivals, AreNoneOfOtherVerdictsAndOfModels) {
  EXPECT_THAT(RivalsOf(VerdictText("explained", "cubic_damping.sway", R"("thruster_lag")")).pairs,
              IsEmpty());
  EXPECT_THAT(RivalsOf(R"({"schema": "fathom-model-2"})").pairs, IsEmpty());
}

TEST(VerdictRivals, LeaveOutWhatAWrenchDoesNotTell) {
  const VerdictRivals open =
      RivalsOf(VerdictText("ambiguous",
                           "cubic_damping.sway",
                           R"("thrust_gain.port", "current.east.dive_3", "cubic_damping.heave")"));
  EXPECT_THAT(open.pairs, IsEmpty());
  EXPECT_THAT(
      open.left_out,
      ElementsAre("cubic_damping.sway against thrust_gain.port is left out: a wrench tells nothing "
                  "of single thrusters and fins.",
                  "cubic_damping.sway against current.east.dive_3 is left out: it belongs to one "
                  "log: any new one tells.",
                  "cubic_damping.sway against cubic_damping.heave is left out: its DOF is not "
                  "modelled."));
}

TEST(VerdictRivals, MustBeEntriesAndTheNamedOneIdentified) {
  const auto error_of = [](const std::string& entry, const std::string& alternatives) {
    return ErrorFrom([&] { RivalsOf(VerdictText("ambiguous", entry, alternatives)); });
  };
  EXPECT_THAT(error_of("thruster_lag", R"("time_offset")"),
              ::testing::HasSubstr("boat.json: 'causes[0].entry' is 'thruster_lag', expected a "
                                   "number that the model identified"));
  EXPECT_THAT(error_of("cubic_damping.sway", R"("inertia.up")"),
              ::testing::HasSubstr("'causes[0].alternatives' names no entry: 'inertia.up'"));
}

}  // namespace
}  // namespace fathom
