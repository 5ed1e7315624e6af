// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Logs that others recorded, whose causes are known from the rigs (INDEX_single_dof.md there).

#include "fathom/diagnosis/diagnosis.h"
#include "fathom/diagnosis/options.h"
#include "fathom/diagnosis/report/verdict_sentence.h"
#include "fathom/log/read_log.h"

#include <cmath>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "real_data.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

// The names of the causes.
std::vector<std::string_view> Named(const Diagnosis& diagnosis) {
  std::vector<std::string_view> names;
  for (const ActiveEffect& active : diagnosis.extended.model.effects) {
    names.push_back(active.effect->info().name);
  }
  return names;
}

using Names = std::vector<std::string_view>;

class RealCauses : public OnRealData {
 protected:
  Diagnosis DiagnosisOf(const std::string& name, Dof dof) const {
    const std::vector<Log> logs = {ReadLog(folder_ / name)};
    return Diagnose(logs, dof, {});
  }
};

// A cart on a ball screw. Published: mass 95 kg, dry friction 20 N, on another run of the rig.
TEST_F(RealCauses, DryFrictionIsNamedFromSpeedsAndFromPositionsAlike) {
  for (const char* log : {"emps_pulses_velocity", "emps_pulses_pose"}) {
    const Diagnosis diagnosis = DiagnosisOf(log, Dof::kSurge);
    ASSERT_TRUE(diagnosis.IsUsable()) << log;
    EXPECT_EQ(Named(diagnosis), Names{"coulomb_friction"}) << log;
    EXPECT_NEAR(diagnosis.extended.model.baseline.inertia, 95.0, 10.0) << log;
    EXPECT_LT(diagnosis.extended.held_out.nmae, 0.6 * diagnosis.baseline.held_out.nmae) << log;
  }
}

// A geared motor that stands still below 2 V, and stops from 25 rad/s in half a second.
TEST_F(RealCauses, FrictionThatHoldsAMotorIsNamed) {
  const Diagnosis diagnosis = DiagnosisOf("dc_motor_stairs", Dof::kYaw);
  EXPECT_EQ(Named(diagnosis), Names{"coulomb_friction"});
  EXPECT_NEAR(diagnosis.extended.model.effects[0].values[0], 2.14, 0.1);
  EXPECT_LT(diagnosis.extended.held_out.nmae, 0.05);
}

// An electronic oscillator, m x'' + d x' + k x + k3 x^3: m 0.0537, k 0.99 at small amplitudes.
TEST_F(RealCauses, ASpringIsNamedWhereThereIsNoBaseline) {
  for (const char* log : {"silverbox_small", "silverbox_sweep"}) {
    const Diagnosis diagnosis = DiagnosisOf(log, Dof::kSurge);
    ASSERT_TRUE(diagnosis.IsUsable()) << log << ": " << diagnosis.message;
    EXPECT_EQ(Named(diagnosis), Names{"position_stiffness"}) << log;
    EXPECT_GT(diagnosis.extended.model.effects[0].values[0], 0.9) << log;
    EXPECT_LT(diagnosis.extended.model.effects[0].values[0], 1.3) << log;
    // Without the spring there is no model to compare with, so nothing is said of one.
    EXPECT_FALSE(diagnosis.has_baseline) << log;
    EXPECT_TRUE(std::isnan(diagnosis.baseline.held_out.nmae)) << log;
    EXPECT_TRUE(
        VerdictSentence(diagnosis).starts_with("No surge model without a cause fits this "
                                               "log. One with this cause does:"))
        << VerdictSentence(diagnosis);
  }
}

// Twelve short runs of a shaft that needs nothing but inertia, damping and a constant torque.
TEST_F(RealCauses, ShortRunsThatNeedNothingGetNothing) {
  int num_consistent = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "hsm150_runs")) {
    const Diagnosis diagnosis =
        DiagnosisOf("hsm150_runs/" + entry.path().filename().string(), Dof::kYaw);
    num_consistent += diagnosis.verdict == Verdict::kConsistent;
    EXPECT_EQ(Named(diagnosis), Names{}) << entry.path();
  }
  EXPECT_GE(num_consistent, 11);
}

}  // namespace
}  // namespace fathom
