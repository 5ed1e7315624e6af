// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/report/archive_sentences.h"

#include "fathom/archive/report/log_states.h"

#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using testing::ElementsAre;

void AddDives(int count, bool usable, const std::string& vehicle, ArchiveReport* report) {
  for (int dive = 0; dive < count; ++dive) {
    DiveFitRow row;
    row.dive = fmt::format("{} {}", vehicle, dive);
    row.dof = "surge";
    row.vehicle = vehicle;
    row.usable = usable;
    row.value = 1.0;
    report->tables.dive_fits.push_back(row);
  }
}

ArchiveReport WithStates(const std::vector<std::string>& states) {
  ArchiveReport report;
  for (const std::string& state : states) {
    LogRow log;
    log.path = fmt::format("log {}", report.tables.logs.size());
    log.dive = "a";
    log.status = state;
    report.tables.logs.push_back(log);
  }
  return report;
}

TEST(CoupledSentence, CountsVerdictsAndWhatTheyName) {
  Tables tables;
  tables.verdicts.push_back({"a", "surge", "unexplained", "", ""});
  EXPECT_EQ(CoupledSentence(tables), "");
  tables.verdicts.push_back({"a", "surge,yaw", "explained", "", ""});
  CauseRow cause;
  cause.dof = "surge,yaw";
  cause.parameter = "thrust_gain.port";
  tables.causes.push_back(cause);
  EXPECT_EQ(CoupledSentence(tables),
            "1 coupled model: 1 explained. It names thrust_gain.port (1 log).");
  tables.causes.push_back(cause);
  tables.verdicts.push_back({"b", "surge,yaw", "explained", "", ""});
  tables.verdicts.push_back({"c", "surge,yaw", "consistent", "", ""});
  EXPECT_EQ(CoupledSentence(tables),
            "3 coupled models: 1 consistent, 2 explained. They name thrust_gain.port (2 logs).");
}

TEST(CoupledSentence, SaysThatChangesAreThoseOfCoupledModels) {
  ArchiveReport report;
  report.tables.verdicts.push_back({"a", "surge,yaw", "consistent", "", ""});
  AddDives(5, true, "rov", &report);
  EXPECT_EQ(CoupledSentence(report.tables), "1 coupled model: 1 consistent.");
  for (std::size_t dive = 0; dive < 5; ++dive) {
    DiveFitRow row = report.tables.dive_fits[dive];
    row.dof = "surge,yaw";
    report.tables.dive_fits.push_back(row);
  }
  EXPECT_EQ(
      CoupledSentence(report.tables),
      "1 coupled model: 1 consistent. Changes along their DOFs are told from one coupled model "
      "a dive.");
}

TEST(ChangeSentences, TellThatNothingChanged) {
  ArchiveReport report;
  AddDives(12, true, "", &report);
  EXPECT_THAT(ChangeSentences(report.tables), ElementsAre("No change over 12 dives."));
}

// Six hulls, two dives each: no step can be placed.
TEST(ChangeSentences, SayWhereDivesDifferByFarMoreThanTheirIntervals) {
  const double hulls[] = {5.0, 14.0, 9.0, 22.0, 5.2, 31.0};
  ArchiveReport report;
  AddDives(12, true, "", &report);
  for (std::size_t dive = 0; dive < 12; ++dive) {
    DiveFitRow& row = report.tables.dive_fits[dive];
    row.dive = fmt::format("dive_{:02}", dive + 1);
    row.dof = "yaw";
    row.parameter = "inertia";
    row.unit = "kg m^2";
    row.value = hulls[dive / 2] + (dive % 2 == 0 ? 0.1 : -0.1);
    row.std = 0.5;
  }
  EXPECT_THAT(
      ChangeSentences(report.tables),
      ElementsAre(
          "The dives differ by far more than their intervals: inertia in yaw lies between 4.9 "
          "and 31.1 kg m², at ± 0.98 to 0.98. Together stand: 5.1 in dive_01, dive_02, "
          "dive_09, dive_10; 9 in dive_05, dive_06; 14 in dive_03, dive_04; 22 in dive_07, "
          "dive_08; 31 in dive_11, dive_12. One model for all of them is wrong for most.",
          "No step or trend explains it over 12 dives."));
  // A change that was found explains its parameter.
  ChangeRow change;
  change.dof = "yaw";
  change.parameter = "inertia";
  change.text = "The inertia changes.";
  report.tables.changes.push_back(change);
  EXPECT_THAT(ChangeSentences(report.tables), ElementsAre("The inertia changes."));
}

// Intervals that are right, or too narrow by half, are no difference.
TEST(ChangeSentences, DoNotTakeScatterForADifference) {
  ArchiveReport report;
  AddDives(12, true, "", &report);
  for (std::size_t dive = 0; dive < 12; ++dive) {
    DiveFitRow& row = report.tables.dive_fits[dive];
    row.value = 10.0 + (dive % 3 == 0 ? 1.0 : dive % 3 == 1 ? -1.0 : 0.0);
    row.std = 0.5;
  }
  EXPECT_THAT(ChangeSentences(report.tables), ElementsAre("No change over 12 dives."));
}

// A family that is better counts, and held-out data count before training data.
TEST(ChangeSentences, WarnOfPoorModels) {
  ArchiveReport report;
  AddDives(12, true, "", &report);
  for (int log = 0; log < 8; ++log) {
    ScoreRow row;
    row.log = fmt::format("log {}", log);
    row.dof = "surge";
    row.nmae = 0.9;
    report.tables.scores.push_back(row);
    row.nmae = 0.1;
    row.heldout_nmae = log < 2 ? 0.6 : 0.4;
    report.tables.scores.push_back(row);
  }
  EXPECT_THAT(ChangeSentences(report.tables),
              ElementsAre("No change over 12 dives.",
                          "2 of 8 models of single logs miss over half of the motion (NMAE above "
                          "0.5): changes can hide behind that."));
  ScoreRow good;
  good.log = "log 8";
  good.nmae = 0.1;
  report.tables.scores.push_back(good);
  EXPECT_THAT(ChangeSentences(report.tables), ElementsAre("No change over 12 dives."));
}

TEST(ChangeSentences, SayNothingOfTooFewDives) {
  ArchiveReport report;
  AddDives(1, true, "", &report);
  EXPECT_THAT(ChangeSentences(report.tables),
              ElementsAre("No statement on change: only 1 dive has a usable joint fit, at least 5 "
                          "are needed."));
}

TEST(ChangeSentences, SayNothingWithoutUsableFits) {
  ArchiveReport report;
  AddDives(30, false, "", &report);
  EXPECT_THAT(ChangeSentences(report.tables),
              ElementsAre("No statement on change: no dive has a usable joint fit."));
}

TEST(ChangeSentences, TellOfVehiclesThatDidNotChangeBesideOneThatDid) {
  ArchiveReport report;
  AddDives(9, true, "lbv", &report);
  AddDives(8, true, "rov", &report);
  report.tables.changes.resize(2);
  report.tables.changes[0].text = report.tables.changes[1].text = "From rov 3 on rov is heavier.";
  report.tables.changes[1].vehicle = "rov";
  report.tables.changes[0].vehicle = "rov";
  EXPECT_THAT(ChangeSentences(report.tables),
              ElementsAre("From rov 3 on rov is heavier.", "No change over 9 dives of lbv."));
}

TEST(ChangeSentences, TellsManyVehiclesOfFewDivesTogether) {
  ArchiveReport report;
  for (const char* vehicle : {"a", "b", "c"}) AddDives(4, true, vehicle, &report);
  AddDives(9, true, "lbv", &report);
  EXPECT_THAT(ChangeSentences(report.tables),
              ElementsAre("No change over 9 dives of lbv.",
                          "No statement on change of 3 vehicles: fewer than 5 dives of each have "
                          "a usable joint fit."));
}

TEST(DivesWithoutFitSentence, NamesAFewWithTheReason) {
  Tables tables;
  for (const char* dive : {"dive 1", "dive 2", "dive 3", "dive 4", "dive 5"}) {
    LogRow& log = tables.logs.emplace_back();
    log.dive = dive;
    log.path = log.dive + "/run";
    log.status = log.dive == "dive 3" ? "refused" : "ok";
  }
  const auto add_fit = [&](const std::string& dive, bool usable, const std::string& message) {
    DiveFitRow& row = tables.dive_fits.emplace_back();
    row.dive = dive;
    row.dof = "surge";
    row.usable = usable;
    row.message = message;
  };
  add_fit("dive 1", true, "");
  add_fit("dive 2", false, "The logs disagree.");
  add_fit("dive 4", false, "");
  EXPECT_EQ(DivesWithoutFitSentence(tables),
            "Of 4 dives no DOF has a usable joint fit: dive 2 (surge: The logs disagree), dive 3 "
            "(no log of it gave a model), dive 4 (no fit was made) and 1 more.");
  for (const char* dive : {"dive 2", "dive 3", "dive 4", "dive 5"}) add_fit(dive, true, "");
  EXPECT_EQ(DivesWithoutFitSentence(tables), "");
}

TEST(LogsSentence, CountsEveryState) {
  EXPECT_EQ(LogsSentence(WithStates(StatesInOrder())),
            "11 logs in 1 dive: 2 gave a model (1 ok, 1 partial), 9 did not (1 nothing to "
            "identify, 1 no map, 1 no model, 1 refused, 1 crashed, 1 timed out, 1 out of memory, 1 "
            "unreadable, 1 duplicate).");
}

// A model of data that are wrong is no success.
TEST(LogsSentence, SaysHowManyOfThoseThatGaveAModelAreRed) {
  ArchiveReport report = WithStates({"ok", "ok", "ok", "partial"});
  for (const char* log : {"log 0", "log 0", "log 2", "log 3"}) {
    FindingRow row;
    row.log = log;
    row.severity = std::string(log) == "log 3" ? "yellow" : "red";
    report.tables.findings.push_back(row);
  }
  EXPECT_EQ(LogsSentence(report),
            "4 logs in 1 dive: 4 gave a model (3 ok, 2 of them with red findings; 1 partial).");
}

TEST(LogsSentence, CountsAStateThatItDoesNotKnow) {
  EXPECT_EQ(LogsSentence(WithStates({"ok", "on_fire", ""})),
            "3 logs in 1 dive: 1 gave a model (1 ok), 2 did not (1 no state, 1 on fire).");
}

TEST(LogsSentence, CountsOtherFilesByTheirEnding) {
  ArchiveReport report = WithStates({"crashed"});
  report.other_files = {{".mp4", 2}, {"", 1}};
  EXPECT_EQ(LogsSentence(report),
            "1 log in 1 dive: none gave a model, 1 did not (1 crashed). 3 other files are no logs: "
            "1 without an ending, 2 .mp4.");
}

}  // namespace
}  // namespace fathom
