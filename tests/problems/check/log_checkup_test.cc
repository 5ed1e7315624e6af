// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/check/log_checkup.h"

#include "fathom/check/checkup_json.h"
#include "fathom/check/checkup_text.h"
#include "fathom/check/checkup_verdict.h"
#include "fathom/open_log/open_log.h"
#include "fathom/vehicle/parameters.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include "test_folder.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Field;
using testing::Not;

// A vehicle of 20 kg and 8 kg/s under steps of 3 s, in a table: t, tau, v. `sign`: of the command
// as the table has it.
std::filesystem::path WriteTable(double sign, const std::string& name = "table.csv") {
  const std::filesystem::path path = TestFolder() / name;
  std::ofstream table(path);
  table << "t,tau,v\n";
  double speed = 0.0;
  for (int k = 0; k < 1200; ++k) {
    const int step = k / 30;
    const double force = 10.0 * std::sin(2.4 * step * step);
    speed += 0.1 * (force - 8.0 * speed) / 20.0;
    table << fmt::format("{:.1f},{:.4f},{:.6f}\n", 0.1 * k, sign * force, speed);
  }
  return path;
}

auto IsOf(const std::string& code, Severity severity) {
  return AllOf(Field(&Finding::code, code), Field(&Finding::severity, severity));
}

TEST(CheckUp, IsNeverGreenerThanTheFit) {
  const LogCheckup turned = CheckUp(WriteTable(-1.0), Dof::kSurge);
  ASSERT_EQ(turned.dofs.size(), 1u);
  ASSERT_TRUE(turned.dofs[0].model.has_value());
  EXPECT_FALSE(turned.dofs[0].model->is_usable);
  EXPECT_THAT(turned.dofs[0].findings, Contains(IsOf("force_sign", Severity::kWarning)));
  // No fault of the data by itself: sound logs may tell too little.
  EXPECT_THAT(turned.dofs[0].findings, Contains(IsOf("no_model", Severity::kNote)));
}

// Output error cannot reach a negative inertia, and an experiment does not mend a sign.
TEST(CheckUp, NamesTheSignWhereOutputErrorFailsByIt) {
  const LogCheckup turned = CheckUp(WriteTable(-1.0), Dof::kSurge);
  EXPECT_THAT(turned.dofs[0].model->message,
              testing::ContainsRegex("^The inertia would be -.* Check the sign of the force"));
}

TEST(CheckUp, SaysTheSameOfALogThatWasOpenedAlready) {
  const std::filesystem::path table = WriteTable(1.0);
  const Log log = OpenLog(table, {.dof = Dof::kSurge});
  EXPECT_EQ(FormatCheckupJson(CheckUp(log, {.dof = Dof::kSurge})),
            FormatCheckupJson(CheckUp(table, Dof::kSurge)));
}

// Of the table's command a rudder is made, which alone drives it then.
TEST(CheckUp, SendsALogOfFinsToACoupledModel) {
  Log log = OpenLog(WriteTable(1.0), {.dof = Dof::kSurge});
  log.fins = Stream{log.command->time, {"fin_rudder"}, log.command->values};
  for (double& angle : log.fins->values[0]) angle *= 0.01;  // [rad]
  log.command.reset();
  const LogCheckup checkup = CheckUp(std::move(log), {.dof = Dof::kSurge});
  ASSERT_EQ(checkup.dofs.size(), 1u);
  EXPECT_THAT(checkup.dofs[0].why_not, testing::StartsWith("fins alone steer it"));
  EXPECT_THAT(Verdict(checkup), testing::StartsWith("No model of one DOF comes of this log"));
  EXPECT_THAT(NextStep(checkup), testing::EndsWith(" --dofs=surge --model=coupled.json"));
}

// A single CSV does not say its DOF: without --dof the command would be refused.
TEST(NextStep, ChecksAgainWhatWasAskedFor) {
  const std::filesystem::path table = WriteTable(-1.0);
  EXPECT_EQ(
      NextStep(CheckUp(table, Dof::kSurge)),
      fmt::format("mend what is red, then fathom_check --log={} --dof=surge", table.string()));
}

// The same model of both axes.
LogCheckup OfSurgeAndSway(const std::string& code) {
  LogCheckup checkup = CheckUp(WriteTable(1.0), Dof::kSurge);
  checkup.asked.dof.reset();
  checkup.dofs.push_back(checkup.dofs[0]);
  checkup.dofs[1].dof = Dof::kSway;
  if (!code.empty()) checkup.dofs[1].findings.push_back({Severity::kNote, code, "A finding."});
  return checkup;
}

// A model of each axis alone would be biased.
TEST(NextStep, FitsAxesThatCoupleAsOneMotion) {
  const LogCheckup checkup = OfSurgeAndSway("other_axes");
  EXPECT_THAT(NextStep(checkup), testing::EndsWith(" --dofs=surge,sway --model=coupled.json"));
  EXPECT_THAT(PlanSteps(checkup), testing::IsEmpty());
  EXPECT_THAT(NextStep(OfSurgeAndSway("")), testing::EndsWith("; likewise sway"));
}

TEST(PlanSteps, WriteAFolderForEachAxis) {
  EXPECT_THAT(
      PlanSteps(OfSurgeAndSway("")),
      testing::ElementsAre(testing::EndsWith("plan_surge"), testing::EndsWith("plan_sway")));
  EXPECT_THAT(PlanSteps(CheckUp(WriteTable(1.0), Dof::kSurge)),
              testing::ElementsAre(testing::EndsWith("--out=plan")));
}

TEST(Verdict, LeavesNoAxisUnknownByTheModelOfAnother) {
  LogCheckup checkup = OfSurgeAndSway("poor_fit");
  checkup.dofs[0].findings.push_back({Severity::kNote, "other_axes", "A finding."});
  EXPECT_EQ(Verdict(checkup),
            "A model of sway from this log fits poorly. The log leaves quadratic_damping of surge "
            "and quadratic_damping of sway unknown. Other axes act on surge: a model of one axis "
            "alone is biased.");
}

// The vehicle floats freely: an interval of a few thousandths of the force beside a value of 0.
TEST(DeterminedTable, JudgesABuoyancyByTheGreatestForce) {
  const LogCheckup checkup = CheckUp(WriteTable(1.0), Dof::kSurge);
  EXPECT_EQ(DeterminedTable(checkup, checkup.dofs[0]).rows[kBuoyancy].cells.back(), "well");
}

// 20 kg. Five times the mass would be a warning.
TEST(CheckUp, NotesAnInertiaOfUnusuallyManyMasses) {
  Log log = OpenLog(WriteTable(1.0), {.dof = Dof::kSurge});
  const auto findings = [&](double mass) {
    log.mass = mass;
    return CheckUp(log, {.dof = Dof::kSurge}).dofs[0].findings;
  };
  EXPECT_THAT(findings(5.0), Contains(IsOf("heavy", Severity::kNote)));
  EXPECT_THAT(findings(10.0), Not(Contains(Field(&Finding::code, "heavy"))));
  EXPECT_THAT(findings(1.0), Contains(IsOf("inertia", Severity::kWarning)));
  EXPECT_THAT(findings(1.0), Not(Contains(Field(&Finding::code, "heavy"))));
}

TEST(NextStep, QuotesAFileForAShell) {
  const std::filesystem::path table = WriteTable(1.0, "my table.csv");
  EXPECT_EQ(
      NextStep(CheckUp(table, Dof::kSurge)),
      fmt::format("fathom_identify --log='{}' --dof=surge --model=surge.json", table.string()));
}

TEST(CheckUp, FindsNoFaultInASoundTable) {
  const LogCheckup sound = CheckUp(WriteTable(1.0), Dof::kSurge);
  ASSERT_EQ(sound.dofs.size(), 1u);
  EXPECT_TRUE(sound.dofs[0].model->is_usable);
  EXPECT_NEAR(sound.dofs[0].model->fitted.model.inertia, 20.0, 1.5);
  EXPECT_THAT(sound.dofs[0].findings, Not(Contains(Field(&Finding::severity, Severity::kWarning))));
}

}  // namespace
}  // namespace fathom
