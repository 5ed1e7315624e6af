// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/report/dive_summary.h"

#include <cmath>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using testing::ElementsAre;
using testing::Pair;

LogRow LogOf(const char* path, const char* dive, const char* status) {
  LogRow log;
  log.path = path;
  log.dive = dive;
  log.status = status;
  return log;
}

TEST(DiveSummary, HasEveryDiveInItsOrderAndThenThoseOfLogsAlone) {
  ArchiveReport report;
  report.dives = {"b", "a"};
  report.tables.logs = {LogOf("x", "c", "ok"), LogOf("y", "a", "ok"), LogOf("z", "", "unreadable")};
  std::vector<std::string> dives;
  for (const DiveSummary& summary : SummariesOf(report)) dives.push_back(summary.dive);
  EXPECT_THAT(dives, ElementsAre("b", "a", "c", ""));
}

TEST(DiveSummary, TakesTheBestModelOfALogAndTheWorstLogOfADive) {
  ArchiveReport report;
  report.dives = {"a"};
  report.tables.logs = {LogOf("x", "a", "ok"), LogOf("y", "a", "ok")};
  report.tables.scores = {{"x", "surge", "output_error", "", 0, 0, 0, 0.3},
                          {"x", "surge", "adaptive", "", 0, 0, 0, 0.9},
                          {"y", "surge", "output_error", "", 0, 0, 0, kNoNumber},
                          {"y", "surge", "adaptive", "", 0, 0, 0, 0.2}};
  EXPECT_EQ(SummariesOf(report)[0].HeldOutNmae(), 0.3);
}

TEST(DiveSummary, KnowsNoScoreWhereThereIsNone) {
  ArchiveReport report;
  report.dives = {"a"};
  EXPECT_TRUE(std::isnan(SummariesOf(report)[0].HeldOutNmae()));
}

TEST(DiveSummary, CountsALogOnceForEachEffectThatItNames) {
  ArchiveReport report;
  report.dives = {"a"};
  report.tables.logs = {LogOf("x", "a", "ok"), LogOf("y", "a", "ok")};
  for (const char* log : {"x", "y"}) {
    for (const char* parameter : {"width", "slope"}) {
      CauseRow row;
      row.log = log;
      row.dof = "surge";
      row.effect = "thrust_dead_zone";
      row.parameter = parameter;
      report.tables.causes.push_back(row);
    }
  }
  report.tables.verdicts = {{"x", "surge", "explained", "", ""}};
  const DiveDofSummary surge = SummariesOf(report)[0].dofs.at("surge");
  EXPECT_THAT(surge.causes, ElementsAre(Pair("thrust_dead_zone", 2)));
  EXPECT_THAT(surge.verdicts, ElementsAre(Pair("explained", 1)));
}

TEST(WorstFirst, GoesByLostLogsThenRedFindingsThenScores) {
  std::vector<DiveSummary> summaries(5);
  summaries[1].dofs["surge"].heldout_nmae = 0.2;
  summaries[2].num_red = 1;
  summaries[3].num_without_model = 1;
  summaries[4].dofs["yaw"].heldout_nmae = 0.3;
  EXPECT_THAT(WorstFirst(summaries), ElementsAre(3, 2, 4, 1, 0));
}

}  // namespace
}  // namespace fathom
