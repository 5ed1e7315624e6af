// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// What learned weights are for: the errors of the estimator that knows the noise, and intervals
// that hold. The table of docs/output_error.md has more kinds of noise and more logs.

#include "fathom/output_error/weighting.h"

#include "fathom/base/input_error.h"
#include "fathom/output_error/output_error.h"

#include <cmath>
#include <string>
#include <vector>

#include "noise_trial.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

OutputErrorSummary FitBy(Weighting weighting, const NoiseTrial& trial, const Segment& segment) {
  OutputErrorOptions options;
  options.initial_guess = trial.truth();
  options.output = trial.kind().output;
  options.weighting = weighting;
  return FitOutputError({&segment, 1}, options);
}

struct Rates {
  ParameterVector squares = ParameterVector::Zero();  // of errors
  ParameterVector covered = ParameterVector::Zero();
};

void Add(const ParameterVector& error, const ParameterVector& std, Rates* rates) {
  rates->squares += error.cwiseAbs2();
  rates->covered += (error.cwiseAbs().array() <= 1.96 * std.array()).cast<double>().matrix();
}

class WeightingUnder : public ::testing::TestWithParam<NoiseKind> {};

// The two errors have a correlation of 0.95 and more, so the ratio of their root mean squares over
// 80 logs scatters by sqrt(1 - 0.95^2) / sqrt(80) = 0.035. In the table it is at most 1.09: 1.2. A
// rate of coverage of 0.93 scatters by 0.029: 0.84 at least; one of 0.895, of plain weights, by
// 0.034: 0.80.
TEST_P(WeightingUnder, LearnedHasTheErrorsOfTheOracleAndBothHaveIntervalsThatCover) {
  constexpr int kNumLogs = 80;
  const NoiseTrial trial(GetParam());
  const ParameterVector truth = ToVector(trial.truth());
  Rates oracle, learned, plain;
  for (unsigned seed = 1; seed <= kNumLogs; ++seed) {
    const Segment segment = trial.Draw(seed);
    Add(trial.Oracle(segment) - truth, trial.OracleStd(), &oracle);
    const auto fit = FitBy(Weighting::kLearned, trial, segment);
    ASSERT_TRUE(fit.IsUsable()) << "seed " << seed << ": " << fit.message;
    ASSERT_EQ(fit.weighting, Weighting::kLearned);
    Add(ToVector(fit.model) - truth, fit.covariance.diagonal().cwiseSqrt(), &learned);
    const auto by_plain = FitBy(Weighting::kPlain, trial, segment);
    Add(ToVector(by_plain.model) - truth, by_plain.covariance.diagonal().cwiseSqrt(), &plain);
  }
  for (int i = 0; i < kNumParameters; ++i) {
    const std::string name = kParameterInfo[i].name;
    EXPECT_LT(std::sqrt(learned.squares[i] / oracle.squares[i]), 1.2) << name;
    EXPECT_GT(learned.covered[i] / kNumLogs, 0.84) << name;
    if (trial.kind().output == FittedOutput::kPosition) continue;  // they say that they are short
    EXPECT_GT(plain.covered[i] / kNumLogs, 0.80) << name;
  }
}

std::string Title(const ::testing::TestParamInfo<NoiseKind>& info) {
  std::string title;
  for (const char c : info.param.name) {
    if (std::isalpha(static_cast<unsigned char>(c))) title += c;
  }
  return title;
}

std::vector<NoiseKind> KindsNamed(const std::vector<std::string>& names) {
  std::vector<NoiseKind> kinds;
  for (const NoiseKind& kind : AllNoiseKinds()) {
    for (const std::string& name : names) {
      if (kind.name == name) kinds.push_back(kind);
    }
  }
  return kinds;
}

INSTANTIATE_TEST_SUITE_P(EachNoise,
                         WeightingUnder,
                         ::testing::ValuesIn(KindsNamed({"white",
                                                         "white and coloured",
                                                         "mild turbulence",
                                                         "mild turbulence, positions"})),
                         Title);

TEST(Weighting, LearnedLeavesWildSamplesOut) {
  const NoiseTrial trial(KindsNamed({"mild turbulence"}).front());
  Segment segment = trial.Draw(3);
  const auto clean = FitBy(Weighting::kLearned, trial, segment);
  for (size_t i = 10; i < segment.velocity.size(); i += 50) segment.velocity[i] += 1.0;
  const auto spoilt = FitBy(Weighting::kLearned, trial, segment);
  ASSERT_EQ(spoilt.weighting, Weighting::kLearned) << spoilt.weighting_reason;
  for (int i = 0; i < kNumParameters; ++i) {
    // Two per cent of the samples are gone.
    EXPECT_NEAR(ToVector(spoilt.model)[i],
                ToVector(clean.model)[i],
                0.5 * std::sqrt(clean.covariance(i, i)))
        << kParameterInfo[i].name;
  }
}

// Whose intervals hold 42 % of buoyancies in the table, of nominal 95.
TEST(Weighting, PlainSaysThatItsIntervalsAreTooShortWhereAPositionWanders) {
  const auto caveats_by = [](Weighting weighting, const char* kind) {
    const NoiseTrial trial(KindsNamed({kind}).front());
    return FitBy(weighting, trial, trial.Draw(1)).caveats;
  };
  EXPECT_THAT(caveats_by(Weighting::kPlain, "mild turbulence, positions"),
              Contains(HasSubstr("the position wanders")));
  EXPECT_THAT(caveats_by(Weighting::kLearned, "mild turbulence, positions"),
              Not(Contains(HasSubstr("wanders"))));
  EXPECT_THAT(caveats_by(Weighting::kPlain, "white, positions"),
              Not(Contains(HasSubstr("wanders"))));
}

// The answer that there is, and why it is not the one that was asked for.
TEST(Weighting, StaysPlainWhereNoNoiseCanBeLearned) {
  const NoiseTrial trial(KindsNamed({"white"}).front());
  OutputErrorOptions options;
  options.max_iterations = 1;  // too few for the plain search
  options.initial_guess = trial.truth();
  options.initial_guess->inertia *= 3.0;
  const Segment segment = trial.Draw(1);
  options.weighting = Weighting::kLearned;
  const auto fit = FitOutputError({&segment, 1}, options);
  EXPECT_EQ(fit.weighting, Weighting::kPlain);
  EXPECT_EQ(fit.weighting_reason, "The plain search did not converge.");
}

TEST(Weighting, IsReadByItsName) {
  for (const Weighting weighting : {Weighting::kPlain, Weighting::kLearned}) {
    EXPECT_EQ(ParseWeighting(std::string(Name(weighting))), weighting);
  }
  EXPECT_THROW(ParseWeighting("auto"), InputError);
}

}  // namespace
}  // namespace fathom
