// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/identification/run_agreement.h"

#include "fathom/identification/run_agreement_text.h"

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

RunEstimate RunOf(const std::string& log, double inertia, double std) {
  RunEstimate run;
  run.log = log;
  run.is_usable = true;
  run.value = {inertia, 60.0, 20.0, 0.0};
  run.std = {std, 5.0, 2.0, 0.1};
  return run;
}

// Values 10, 12, 17 with variances 1, 1, 4: weights 1, 1, 1/4, mean 26.25 / 2.25 = 11.667,
// chi-square 2.778 + 0.111 + 7.111 = 10.
TEST(AgreementOf, HasTheChiSquareWorkedOutByHand) {
  const RunAgreement agreement =
      AgreementOf({RunOf("a", 10.0, 1.0), RunOf("b", 12.0, 1.0), RunOf("c", 17.0, 2.0)});
  const Spread& inertia = agreement.spreads[kInertia];
  EXPECT_NEAR(inertia.chi_squared, 10.0, 1e-9);
  EXPECT_EQ(inertia.freedom, 2);
  EXPECT_NEAR(inertia.p_value, std::exp(-5.0), 1e-9);  // of two degrees of freedom
  EXPECT_NEAR(inertia.widening, std::sqrt(5.0), 1e-9);
  EXPECT_EQ(agreement.spreads[kQuadraticDamping].widening, 1.0);
}

TEST(AgreementOf, NamesTheRunThatStandsApart) {
  std::vector<RunEstimate> runs;
  for (int k = 0; k < 6; ++k) runs.push_back(RunOf("run_" + std::to_string(k), 100.0 + k % 2, 1.0));
  EXPECT_THAT(AgreementOf(runs).stands_apart, IsEmpty());
  EXPECT_THAT(RemarksOn(AgreementOf(runs), ParameterVector::Ones()), IsEmpty());
  runs[3].value[kInertia] = 120.0;
  const RunAgreement agreement = AgreementOf(runs);
  EXPECT_EQ(agreement.stands_apart, "run_3");
  EXPECT_EQ(agreement.parameter_apart, kInertia);
  EXPECT_THAT(
      RemarksOn(agreement, {7.0, 1.0, 88.3, 1.0}),
      ElementsAre(
          HasSubstr("widened: inertia by a factor of 7.0, linear damping by a factor of 88."),
          HasSubstr("run_3 stands apart")));
}

// Chi-square 18 with one degree of freedom. The intervals of the joint fit hold that already.
TEST(RemarksOnRuns, TellThatTheyDisagreeWhereNoIntervalIsWidened) {
  const RunAgreement agreement = AgreementOf({RunOf("a", 10.0, 1.0), RunOf("b", 16.0, 1.0)});
  EXPECT_THAT(RemarksOn(agreement, ParameterVector::Ones()),
              ElementsAre(HasSubstr("The runs disagree on the inertia, each by itself")));
  const RunAgreement near = AgreementOf({RunOf("a", 10.0, 1.0), RunOf("b", 13.0, 1.0)});
  EXPECT_THAT(RemarksOn(near, ParameterVector::Ones()), IsEmpty());
}

TEST(AgreementOf, PassesOverRunsThatDetermineNothing) {
  RunEstimate unusable;
  unusable.log = "short";
  const RunAgreement agreement =
      AgreementOf({RunOf("a", 10.0, 1.0), unusable, RunOf("c", 11.0, 1.0)});
  EXPECT_EQ(agreement.spreads[kInertia].freedom, 1);
  EXPECT_EQ(agreement.runs.size(), 3u);
}

// Eight runs, as in realdata/sonia, whose inertia scatters by 2.4 times what their intervals say:
// the interval of all together has to hold the truth in 95 % of cases, less what eight runs tell
// of their own scatter (Student's t with 7 degrees of freedom at 1.96: 91 %).
TEST(AgreementOf, WidensIntervalsToWhatTheyPromise) {
  std::mt19937 generator(7);
  std::normal_distribution<double> normal;
  int num_held = 0, num_held_as_told = 0, num_held_twice_as_wide = 0;
  const int num_trials = 2000;
  for (int trial = 0; trial < num_trials; ++trial) {
    std::vector<RunEstimate> runs;
    double sum = 0.0;
    for (int k = 0; k < 8; ++k) {
      runs.push_back(RunOf("run", 328.0 + 2.4 * 10.0 * normal(generator), 10.0));
      sum += runs.back().value[kInertia];
    }
    const double error = std::abs(sum / 8.0 - 328.0), told = 1.96 * 10.0 / std::sqrt(8.0);
    const Spread spread = AgreementOf(std::move(runs)).spreads[kInertia];
    num_held_as_told += error < told;
    num_held += error < told * spread.WideningOf(told / 1.96);
    // The residual of a fit to all has a part of the differences in it.
    num_held_twice_as_wide += error < 2.0 * told * spread.WideningOf(2.0 * told / 1.96);
  }
  EXPECT_LT(num_held_as_told, 0.65 * num_trials);
  EXPECT_GT(num_held, 0.90 * num_trials);
  EXPECT_LT(num_held, 0.97 * num_trials);
  EXPECT_GE(num_held_twice_as_wide, num_held);
  EXPECT_LT(num_held_twice_as_wide, 0.97 * num_trials);
}

TEST(AgreementOf, WidensNoFitByMoreThanTheRunsDiffer) {
  // 50 apart, each known to 10: the mean to 7.1, and to 25 by its scatter.
  const Spread spread =
      AgreementOf({RunOf("a", 300.0, 10.0), RunOf("b", 350.0, 10.0)}).spreads[kInertia];
  EXPECT_NEAR(spread.mean_std, 10.0 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(spread.mean_std * spread.widening, 25.0, 1e-12);
  EXPECT_NEAR(spread.WideningOf(10.0), 2.5, 1e-12);
  EXPECT_EQ(spread.WideningOf(40.0), 1.0);
  EXPECT_EQ(spread.WideningOf(1.0), spread.widening);
}

}  // namespace
}  // namespace fathom
