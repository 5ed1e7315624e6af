// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// A few logs of the full set (hidden_scores, docs/diagnosis_scores.md), held to the same bars. They
// are few: each bar leaves so much slack that a diagnosis that just holds it fails once in a
// hundred seeds, by the binomial distribution.

#include <cstddef>

#include "binomial.h"
#include "log_plan.h"
#include "run_logs.h"
#include "score_board.h"
#include "scores_page.h"
#include <gtest/gtest.h>

namespace fathom::hidden {
namespace {

constexpr std::uint64_t kSeed = 1;  // of the full set
constexpr double kUnlucky = 0.01;

#if defined(__SANITIZE_ADDRESS__)
constexpr std::size_t kEvery = 3;  // ten times as slow
#else
constexpr std::size_t kEvery = 1;
#endif

// Ten logs with nothing hidden, one of two thirds of the effects, four pairs, four unlisted ones;
// the first of each in the full set.
std::vector<LogPlan> Subset() {
  const auto all = DrawPlans({10, 1, 4, 8}, kSeed);
  std::vector<LogPlan> subset;
  std::size_t num_one = 0, num_unlisted = 0, num_kept = 0;
  for (const LogPlan& plan : all) {
    if (plan.hidden == HiddenClass::kOneEffect && num_one++ % 3 == 2) continue;
    if (plan.hidden == HiddenClass::kUnlisted && num_unlisted++ % 2 == 1) continue;
    if (num_kept++ % kEvery == 0) subset.push_back(plan);
  }
  return subset;
}

const std::vector<LogScore>& Scores() {
  static const std::vector<LogScore> scores = [] {
    OracleCache oracle("");
    return RunLogs(Subset(), kSeed, 2, oracle);
  }();
  return scores;
}

std::string List() {
  std::string text;
  for (const LogScore& score : Scores()) text += Line(score) + "\n";
  return text + Summary(Scores());
}

TEST(Hidden, HoldsTheBarsOnAFewLogs) {
  const ScoreBoard board = BoardOf(Scores());
  const Tally& one = board.separable_one;
  const Tally& two = board.separable_two;
  const int separable = one.logs + two.logs;
  ASSERT_GE(separable, 16 / static_cast<int>(kEvery)) << List();
  ASSERT_GT(board.nothing, 2);
  ASSERT_GT(board.unlisted.logs, 0);

  EXPECT_GE(one.Named() + two.Named(), FewestExpected(separable, 0.90, kUnlucky)) << List();
  EXPECT_GE(one.Of(Outcome::kAlone) + two.Of(Outcome::kAlone),
            FewestExpected(separable, 0.80, kUnlucky))
      << List();
  EXPECT_LE(board.false_causes, MostExpected(board.nothing, 0.05, kUnlucky)) << List();
  EXPECT_LE(board.unlisted_certain, MostExpected(board.unlisted.logs, 0.20, kUnlucky)) << List();
  // The median over a few logs: at most half of them may lie below the bar but for bad luck.
  int num_below = 0;
  for (const double ratio : board.gain_ratios) num_below += ratio < 0.90 ? 1 : 0;
  const int num_gains = static_cast<int>(board.gain_ratios.size());
  EXPECT_LE(num_below, MostExpected(num_gains, 0.5, kUnlucky)) << List();
  const auto missed = [](const Coverage& c) { return c.total - c.inside; };
  EXPECT_LE(missed(board.effect_parameters),
            MostExpected(board.effect_parameters.total, 0.08, kUnlucky))
      << List();
  // The four parameters of one log share their luck: as if there were half as many.
  EXPECT_LE(
      (missed(board.model_parameters) + missed(board.null_model_parameters)) / 2,
      MostExpected(
          (board.model_parameters.total + board.null_model_parameters.total) / 2, 0.08, kUnlucky))
      << List();
}

TEST(Hidden, GivesTheSameScoresWithAnyNumberOfThreads) {
  std::vector<LogPlan> plans = Subset();
  plans.resize(2);
  OracleCache oracle("");
  const auto single = RunLogs(plans, kSeed, 1, oracle), threaded = RunLogs(plans, kSeed, 2, oracle);
  for (std::size_t i = 0; i < plans.size(); ++i) {
    EXPECT_EQ(single[i].named, threaded[i].named);
    EXPECT_EQ(single[i].name, plans[i].Name());
  }
}

}  // namespace
}  // namespace fathom::hidden
