// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/cause_words.h"

#include "fathom/vehicle/coupled/entry_name.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

NamedEntry FinForceOfUpper(double value) { return {FinForceEntry("upper"), value, 0.1, {}, 10.0}; }

TEST(CauseSentence, SaysWhatAFinGivesOfWhatIsStated) {
  const std::string gone = CauseSentence(FinForceOfUpper(0.05), "N");
  EXPECT_THAT(gone, StartsWith("Fin upper gives 0 %"));
  EXPECT_THAT(gone, HasSubstr("of the force that the vehicle file states: it is gone"));
  EXPECT_THAT(CauseSentence(FinForceOfUpper(-9.8), "N"), HasSubstr("it turns the wrong way"));
  EXPECT_THAT(CauseSentence(FinForceOfUpper(7.0), "N"), HasSubstr("it does less"));
}

TEST(CauseSentence, SaysAtWhichAngleAFinIsStuck) {
  const NamedEntry stuck = {FinStuckEntry("port"), 0.1, 0.002, {FinForceEntry("port")}, 0.0};
  const std::string text = CauseSentence(stuck, "N");
  EXPECT_THAT(text, StartsWith("Fin port is stuck at one angle, whatever is commanded: 0.1"));
  EXPECT_THAT(text, HasSubstr("rad"));
  EXPECT_THAT(text, HasSubstr("These data cannot tell it from fin_force.port."));
}

TEST(CauseSentence, SaysHowFastAFinTurns) {
  const NamedEntry slow = {FinRateLimitEntry("port"), 0.15, 0.002, {}, 0.0};
  const std::string text = CauseSentence(slow, "N");
  EXPECT_THAT(text, StartsWith("Fin port turns to its command no faster than this rate: 0.15"));
  EXPECT_THAT(text, HasSubstr("rad/s"));
  CoupledDiagnosis diagnosis;
  diagnosis.causes = {slow};
  EXPECT_THAT(CoupledNextSteps(diagnosis).front(), HasSubstr("Log the angle that fin port has"));
}

TEST(CauseSentence, SaysWhereAFinStalls) {
  const NamedEntry stalls = {FinStallEntry("port"), 0.2, 0.002, {}, 0.0};
  EXPECT_THAT(CauseSentence(stalls, "N"),
              StartsWith("The lift of fin port grows no more from this angle of attack on: 0.2"));
  CoupledDiagnosis diagnosis;
  diagnosis.causes = {stalls};
  EXPECT_THAT(CoupledNextSteps(diagnosis).front(), StartsWith("Turn fin port no further"));
}

TEST(CoupledNextSteps, EndWithThePlanThatTellsTheCausesApart) {
  CoupledDiagnosis diagnosis;
  diagnosis.causes = {
      {ParseFreeEntry("cubic_damping.sway"), 90.0, 20.0, {ThrusterLagEntry()}, 0.0}};
  EXPECT_THAT(CoupledNextSteps(diagnosis).back(), HasSubstr("drive each thruster and each DOF"));
  const std::vector<std::string> planned = CoupledNextSteps(diagnosis, "fathom_plan --out=plan");
  EXPECT_THAT(planned.back(), ::testing::EndsWith(": fathom_plan --out=plan"));
  EXPECT_THAT(planned, ::testing::Not(::testing::Contains(HasSubstr("drive each thruster"))));
}

}  // namespace
}  // namespace fathom
