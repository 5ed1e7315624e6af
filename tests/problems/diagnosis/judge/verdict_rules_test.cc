// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Each rule of a verdict from both sides, on runs and gains that are made by hand.

#include "fathom/diagnosis/judge/verdict_rules.h"

#include "fathom/diagnosis/judge/free_run_ladder.h"
#include "fathom/diagnosis/judge/refutation.h"

#include <cstddef>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

Gain OfLogs(double value, double low, std::size_t better, std::size_t logs = 5) {
  return {.value = value, .low = low, .high = 1.0, .num_logs = logs, .num_better = better};
}

// Two blocks of 10 s: too few for an interval of their gain.
std::vector<FreeRun> TwoBlocks(double miss) {
  return {{.time = {0.0, 10.0}, .measured = {0.0, 0.0}, .predicted = {miss, miss}}};
}

FreeRunComparison InTraining(double before, double after) {
  FreeRunComparison runs;
  runs.train_before.nmae = before;
  runs.train_after.nmae = after;
  runs.unseen.before = runs.unseen.after = TwoBlocks(1.0);
  return runs;
}

TEST(ARungIsClimbed, ForAGainThatIsCertainByATwentieth) {
  EXPECT_TRUE(IsBetterForCertain({.value = 0.3, .low = 0.051, .high = 0.5}));
  EXPECT_FALSE(IsBetterForCertain({.value = 0.3, .low = 0.049, .high = 0.5}));
}

TEST(ARungIsClimbed, ForAFifthWhereThereIsNoInterval) {
  EXPECT_TRUE(IsBetterForCertain({.value = 0.21, .low = kNone, .high = kNone}));
  EXPECT_FALSE(IsBetterForCertain({.value = 0.19, .low = kNone, .high = kNone}));
}

TEST(ARungIsClimbed, WhereEachLogGainsATwentieth) {
  EXPECT_TRUE(IsBetterForCertain(OfLogs(0.051, -0.2, 5)));
  EXPECT_FALSE(IsBetterForCertain(OfLogs(0.049, -0.2, 5)));
  EXPECT_FALSE(IsBetterForCertain(OfLogs(0.3, -0.2, 4)));
}

TEST(AGainOfLogs, ConfirmsWhereEachGainsMoreThanATrace) {
  EXPECT_TRUE(IsConfirmedByLogs(OfLogs(0.011, -0.2, 5)));
  EXPECT_FALSE(IsConfirmedByLogs(OfLogs(0.009, -0.2, 5)));
}

TEST(ALoss, RefutesByATwentiethHoweverLittleTheDataSay) {
  const auto refuting = [](double miss) {
    Scored scored;
    scored.before = TwoBlocks(1.0);
    scored.after = TwoBlocks(miss);
    return RefutingGain(scored, false);
  };
  EXPECT_TRUE(refuting(1.051));
  EXPECT_FALSE(refuting(1.049));
}

TEST(AllCauses, AreRefusedWhereTheyLoseATenthInTraining) {
  EXPECT_FALSE(RefusalOfAll({0}, InTraining(0.10, 0.1099), false, false));
  const auto refusal = RefusalOfAll({0}, InTraining(0.10, 0.1101), false, false);
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->reason, Refusal::Reason::kLosesInTraining);
  EXPECT_FALSE(RefusalOfAll({}, InTraining(0.10, 0.2), false, false));
}

TEST(AllCauses, AreRefusedByTwoLogsWhereMoreRemains) {
  FreeRunComparison runs = InTraining(0.1, 0.1);
  runs.unseen.by_log = true;
  runs.gain = OfLogs(0.3, 0.1, 2, 2);
  const auto refusal = RefusalOfAll({0}, runs, true, true);
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->reason, Refusal::Reason::kTwoLogsTellTooLittle);
  EXPECT_FALSE(RefusalOfAll({0}, runs, true, false));
  runs.gain = OfLogs(0.3, 0.1, 3, 3);
  EXPECT_FALSE(RefusalOfAll({0}, runs, true, true));
}

TEST(AllCauses, AreRefusedWhereLogsDoNotConfirmThem) {
  FreeRunComparison runs = InTraining(0.1, 0.1);
  runs.unseen.by_log = true;
  runs.gain = OfLogs(0.009, -0.1, 5);
  const auto refusal = RefusalOfAll({0}, runs, true, false);
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->reason, Refusal::Reason::kNotConfirmedByLogs);
}

TEST(AllCauses, AreRefusedWhereTogetherTheyGainNothingForCertainAndMoreRemains) {
  FreeRunComparison runs = InTraining(0.1, 0.1);
  runs.gain = {.value = 0.01, .low = -0.01, .high = 0.03};
  const auto refusal = RefusalOfAll({0, 1}, runs, false, true);
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->reason, Refusal::Reason::kGainsNothing);
  EXPECT_FALSE(RefusalOfAll({0, 1}, runs, false, false));  // nothing but noise remains
  EXPECT_FALSE(RefusalOfAll({0, 1}, runs, true, true));    // nothing was held out
  runs.gain = {.value = 0.01, .low = 0.001, .high = 0.02};
  EXPECT_FALSE(RefusalOfAll({0, 1}, runs, false, true));
}

TEST(AllCauses, StandWhereLeftOutBlocksRefuseThemWithoutCertainty) {
  FreeRunComparison runs = InTraining(0.1, 0.1);
  runs.unseen.after = TwoBlocks(1.06);
  EXPECT_TRUE(RefusalOfAll({0}, runs, false, false));
  runs.gain = {.value = -0.06, .low = kNone, .high = kNone};
  EXPECT_FALSE(RefusalOfAll({0}, runs, true, false));
  runs.gain = {.value = -0.06, .low = -0.1, .high = -0.02};
  EXPECT_TRUE(RefusalOfAll({0}, runs, true, false));
}

}  // namespace
}  // namespace fathom
