// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/judge/ranking.h"

#include "fathom/base/random_stream.h"
#include "fathom/diagnosis/search/suspects.h"
#include "fathom/vehicle/effects/catalogue.h"
#include "fathom/vehicle/parameters.h"

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

// A search whose suspects have one trial each.
class RankCandidatesTest : public testing::Test {
 protected:
  RankCandidatesTest() {
    for (const char* name : {"thruster_lag",
                             "thrust_dead_zone",
                             "time_offset",
                             "thrust_curve",
                             "cubic_damping",
                             "steady_current"}) {
      Suspects().push_back({FindEffect(name), {}});
    }
    const int n = static_cast<int>(Suspects().size());
    RandomStream random(1, "test");
    Eigen::MatrixXd maxima(512, n);
    for (double& number : maxima.reshaped()) number = std::pow(random.Normal(), 2);
    Calibration calibration;
    calibration.significance =
        Significance(maxima, std::vector<int>(n, 1), std::vector<double>(n, 1.0), 0.05);
    Found() = {HypothesisBook({}, calibration), false, std::vector<double>(n, 0.0)};
  }

  void Try(const std::vector<int>& suspects, double gain) {
    Hypothesis hypothesis;
    hypothesis.suspects = suspects;
    hypothesis.gain = gain;
    hypothesis.delta_bic = gain - 7.0 * static_cast<double>(suspects.size());
    Eigen::Index num_parameters = kNumParameters;
    for (const int suspect : suspects) {
      const auto size = Suspects()[suspect].effect->info().parameters.size();
      hypothesis.fit.model.effects.push_back({Suspects()[suspect].effect,
                                              Suspects()[suspect].setting,
                                              std::vector<double>(size, 0.5)});
      num_parameters += static_cast<Eigen::Index>(size);
    }
    hypothesis.fit.covariance = Eigen::MatrixXd::Identity(num_parameters, num_parameters);
    hypothesis.fit.converged = true;
    hypothesis.fit.jacobian = RowMajorMatrix::Zero(1, num_parameters);
    Found().book.Add(std::move(hypothesis));
  }

  std::map<std::string, Candidate> Ranked() const {
    std::map<std::string, Candidate> by_label;
    for (Candidate& candidate : RankCandidates(judgement_)) {
      by_label[candidate.label] = std::move(candidate);
    }
    return by_label;
  }

  std::vector<Suspect>& Suspects() { return judgement_.search.suspects; }
  SearchResult& Found() { return judgement_.search.found; }

  Judgement judgement_;
};

TEST_F(RankCandidatesTest, SayWhyAScoreHasNoRefit) {
  Found().scores = {40.9, 2.0, 300.0, 0.0, 0.0, 0.0};
  Found().book.AddAttempt({2});
  auto ranked = Ranked();
  // Far above noise, and not among the ten that were refitted.
  EXPECT_LT(ranked["thruster_lag"].p_value, 1e-6);
  EXPECT_EQ(ranked["thruster_lag"].outcome, CandidateOutcome::kOthersScoreHigher);
  EXPECT_GT(ranked["thrust_dead_zone"].p_value, 0.05);
  EXPECT_EQ(ranked["thrust_dead_zone"].outcome, CandidateOutcome::kScoreWithinNoise);
  EXPECT_EQ(ranked["time_offset"].outcome, CandidateOutcome::kFitFailed);
}

TEST_F(RankCandidatesTest, CallItNoiseJustWhereThePValueDoes) {
  for (double score = 0.0; score < 60.0; score += 1.5) {
    Found().scores.assign(Suspects().size(), score);
    for (const auto& [label, candidate] : Ranked()) {
      const bool is_noise = candidate.outcome == CandidateOutcome::kScoreWithinNoise;
      EXPECT_EQ(is_noise, candidate.p_value > 0.05) << label << ' ' << score;
    }
  }
}

TEST_F(RankCandidatesTest, SayWhyARefitWasKeptOrDropped) {
  Found().scores.assign(Suspects().size(), 50.0);
  Try({0}, 90.0);  // index 1
  Try({1}, 3.0);
  Try({2}, 88.0);  // index 3: a rival
  Try({3}, 60.0);
  judgement_.choice.chosen = 1;
  judgement_.rivals = {3};
  auto ranked = Ranked();
  EXPECT_EQ(ranked["thruster_lag"].outcome, CandidateOutcome::kKept);
  EXPECT_EQ(ranked["thrust_dead_zone"].outcome, CandidateOutcome::kGainWithinNoise);
  EXPECT_EQ(ranked["time_offset"].outcome, CandidateOutcome::kAlternative);
  EXPECT_EQ(ranked["thrust_curve"].outcome, CandidateOutcome::kNeedless);
  EXPECT_EQ(RankCandidates(judgement_).front().label, "thruster_lag");

  judgement_.choice.chosen = 0;
  judgement_.rivals.clear();
  EXPECT_EQ(Ranked()["thrust_curve"].outcome, CandidateOutcome::kTakenUpByNoise);

  judgement_.choice.refusals.push_back({.refused = {0}});
  EXPECT_EQ(Ranked()["thruster_lag"].outcome, CandidateOutcome::kRefused);
  EXPECT_EQ(Ranked()["thrust_curve"].outcome, CandidateOutcome::kNoBetterThanRefused);
}

// The same effect in two logs is two suspects.
TEST_F(RankCandidatesTest, TellTheLogsOfOneEffectApart) {
  Suspects()[0] = {FindEffect("buoyancy_step"), {.log = "first"}};
  Suspects()[1] = {FindEffect("buoyancy_step"), {.log = "second"}};
  Try({1}, 90.0);
  judgement_.choice.chosen = 1;
  EXPECT_EQ(PlaceIn(Found().book[1].fit.model, Suspects()[0]), -1);
  EXPECT_EQ(PlaceIn(Found().book[1].fit.model, Suspects()[1]), 0);
  const auto ranked = Ranked();
  EXPECT_FALSE(ranked.at("buoyancy_step(first)").IsKept());
  EXPECT_TRUE(ranked.at("buoyancy_step(second)").IsKept());
}

}  // namespace
}  // namespace fathom
