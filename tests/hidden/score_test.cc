// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "score.h"

#include "fathom/vehicle/effects/catalogue.h"

#include <cmath>
#include <string>
#include <vector>

#include "score_board.h"
#include <gtest/gtest.h>

namespace fathom::hidden {
namespace {

constexpr std::uint64_t kScoreSeed = 7;

ActiveEffect Active(const char* name, Dof partner = Dof::kYaw) {
  ActiveEffect active;
  active.effect = FindEffect(name);
  active.setting.partner = partner;
  active.values.assign(active.effect->info().parameters.size(), 0.5);
  return active;
}

// A log that hides these, shortened to what a score looks at.
HiddenLog Hiding(const std::vector<ActiveEffect>& effects) {
  static const HiddenLog drawn = DrawHiddenLog({HiddenClass::kNothing, {}, 0}, kScoreSeed);
  HiddenLog hidden = drawn;
  hidden.plan.hidden = effects.empty()       ? HiddenClass::kNothing
                       : effects.size() == 1 ? HiddenClass::kOneEffect
                                             : HiddenClass::kTwoEffects;
  hidden.truth.model.effects = effects;
  return hidden;
}

struct Named {
  ActiveEffect effect;
  std::vector<std::string> alternatives;
};

Diagnosis Naming(Verdict verdict, const std::vector<Named>& named) {
  Diagnosis diagnosis;
  diagnosis.verdict = verdict;
  diagnosis.extended.model.baseline = {800.0, 50.0, 40.0, 0.0};
  Eigen::Index size = kNumParameters;
  for (const Named& one : named) {
    Cause cause;
    cause.effect_index = static_cast<int>(diagnosis.causes.size());
    for (const std::string& label : one.alternatives) cause.alternatives.push_back({{}, {}, label});
    diagnosis.causes.push_back(cause);
    diagnosis.extended.model.effects.push_back(one.effect);
    size += static_cast<Eigen::Index>(one.effect.values.size());
  }
  diagnosis.extended.covariance = Eigen::MatrixXd::Identity(size, size);
  return diagnosis;
}

LogScore Score(const std::vector<ActiveEffect>& hidden,
               Verdict verdict,
               const std::vector<Named>& named) {
  return ScoreOf(Hiding(hidden), {}, Naming(verdict, named));
}

const ActiveEffect kLag = Active("thruster_lag");
const ActiveEffect kOffset = Active("time_offset");
const ActiveEffect kCurve = Active("thrust_curve");

TEST(Score, CallsTheHiddenCauseNamedAlone) {
  const LogScore score = Score({kLag}, Verdict::kExplained, {{kLag, {}}});
  EXPECT_EQ(score.outcome, Outcome::kAlone);
  EXPECT_EQ(score.effect_parameters.total, 1);
  EXPECT_EQ(score.effect_parameters.inside, 1);
  EXPECT_EQ(score.model_parameters.total, 4);
}

TEST(Score, AcceptsAGroupThatHoldsTheHiddenCause) {
  const std::vector<Named> as_alternative = {{kOffset, {"thruster_lag"}}};
  EXPECT_EQ(Score({kLag}, Verdict::kAmbiguous, as_alternative).outcome, Outcome::kGroup);
  const std::vector<Named> as_first = {{kLag, {"time_offset"}}};
  EXPECT_EQ(Score({kLag}, Verdict::kAmbiguous, as_first).outcome, Outcome::kGroup);
  // Named, but with something left that nothing accounts for: not a certain answer.
  EXPECT_EQ(Score({kLag}, Verdict::kUnexplained, {{kLag, {}}}).outcome, Outcome::kGroup);
}

TEST(Score, TellsAWrongCauseFromAbstention) {
  EXPECT_EQ(Score({kLag}, Verdict::kExplained, {{kCurve, {}}}).outcome, Outcome::kWrong);
  EXPECT_EQ(Score({kLag}, Verdict::kAmbiguous, {{kCurve, {"time_offset"}}}).outcome,
            Outcome::kGroupWithout);
  EXPECT_EQ(Score({kLag}, Verdict::kUnexplained, {}).outcome, Outcome::kAbstained);
  EXPECT_EQ(Score({kLag}, Verdict::kConsistent, {}).outcome, Outcome::kAbstained);
  // The hidden one and another one for certain.
  EXPECT_EQ(Score({kLag}, Verdict::kExplained, {{kLag, {}}, {kCurve, {}}}).outcome,
            Outcome::kWrong);
  // The same effect of another partner is another cause.
  EXPECT_EQ(Score({Active("velocity_coupling", Dof::kSway)},
                  Verdict::kExplained,
                  {{Active("velocity_coupling", Dof::kHeave), {}}})
                .outcome,
            Outcome::kWrong);
}

TEST(Score, WantsACauseForEachOfTwo) {
  const std::vector<ActiveEffect> both = {kCurve, kLag};
  EXPECT_EQ(Score(both, Verdict::kExplained, {{kLag, {}}, {kCurve, {}}}).outcome, Outcome::kAlone);
  EXPECT_EQ(Score(both, Verdict::kAmbiguous, {{kOffset, {"thruster_lag"}}, {kCurve, {}}}).outcome,
            Outcome::kGroup);
  EXPECT_EQ(Score(both, Verdict::kExplained, {{kCurve, {}}}).outcome, Outcome::kPart);
  EXPECT_EQ(Score(both, Verdict::kExplained, {{kCurve, {}}, {kOffset, {}}}).outcome,
            Outcome::kWrong);
  // One answer may not stand for both.
  EXPECT_NE(Score(both, Verdict::kAmbiguous, {{kCurve, {"thruster_lag"}}}).outcome,
            Outcome::kGroup);
}

TEST(Score, CountsFalseCausesOfLogsThatHideNothing) {
  const ScoreBoard board = BoardOf({Score({}, Verdict::kConsistent, {}),
                                    Score({}, Verdict::kUnexplained, {}),
                                    Score({}, Verdict::kAmbiguous, {{kLag, {"time_offset"}}}),
                                    Score({}, Verdict::kExplained, {{kLag, {}}})});
  EXPECT_EQ(board.nothing, 4);
  EXPECT_EQ(board.false_causes, 2);
  EXPECT_EQ(board.false_certain_causes, 1);
  EXPECT_EQ(board.not_consistent, 3);
  EXPECT_EQ(board.null_model_parameters.total, 8);  // of the two logs with nothing named
}

TEST(Score, CountsIntervalsThatMissTheTruth) {
  Diagnosis diagnosis = Naming(Verdict::kExplained, {{kLag, {}}});
  diagnosis.extended.model.effects[0].values[0] = 0.5 + 2.0;  // two standard deviations off
  diagnosis.extended.covariance(0, 0) = std::nan("");
  const LogScore score = ScoreOf(Hiding({kLag}), {}, diagnosis);
  EXPECT_EQ(score.effect_parameters.inside, 0);
  EXPECT_EQ(score.effect_parameters.total, 1);
  EXPECT_EQ(score.model_parameters.total, 3);
  EXPECT_EQ(score.model_parameters.missing, 1);
}

}  // namespace
}  // namespace fathom::hidden
