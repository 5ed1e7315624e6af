// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The same answer whoever asks, in whatever order.

#include "fathom/base/parallel_for.h"
#include "fathom/diagnosis/diagnosis.h"
#include "fathom/vehicle/effects/catalogue.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <string>
#include <vector>

#include "named.h"
#include "surge_run.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

// Three logs of different lengths and inputs with two effects in each.
std::vector<Log> ThreeLogs() {
  std::vector<Log> logs;
  for (int k = 0; k < 3; ++k) {
    SurgeRun run;
    run.name = "run" + std::to_string(k);
    run.input = k == 1 ? Steps({50.0, -20.0, 10.0, -50.0, 30.0, 0.0}, 7.0) : Multisine(30.0);
    run.duration = 60.0 + 30.0 * k;
    run.effects = "thrust_dead_zone:width=10,thruster_lag:time_constant=0.5";
    logs.push_back(LogOf(run, 10 + k));
  }
  return logs;
}

// Every number that a verdict hangs on.
std::vector<double> NumbersOf(const Diagnosis& d) {
  std::vector<double> numbers = {static_cast<double>(d.verdict),
                                 d.explained_share,
                                 d.remaining_p_value,
                                 d.held_out_gain,
                                 d.held_out_gain_low,
                                 d.held_out_gain_high,
                                 d.extended.weighed_log_likelihood,
                                 d.baseline.weighed_log_likelihood,
                                 d.extended.model.baseline.inertia};
  for (const ActiveEffect& active : d.extended.model.effects) {
    numbers.insert(numbers.end(), active.values.begin(), active.values.end());
  }
  for (const Candidate& candidate : d.candidates) {
    numbers.push_back(candidate.score);
    if (!std::isnan(candidate.gain)) numbers.push_back(candidate.gain);
  }
  numbers.insert(numbers.end(), d.missing_force.mean.begin(), d.missing_force.mean.end());
  return numbers;
}

TEST(Diagnose, AnswersTheSameToTheLastBitFromAnyNumberOfThreads) {
  const std::vector<Log> logs = {ThreeLogs()[0]};
  const auto diagnose = [&] { return NumbersOf(Diagnose(logs, Dof::kSurge)); };
  const std::vector<double> alone = diagnose();
  std::vector<std::future<std::vector<double>>> others;
  for (int k = 0; k < 3; ++k) others.push_back(std::async(std::launch::async, diagnose));
  for (auto& other : others) EXPECT_EQ(other.get(), alone);
}

// Cut or not: how far a search goes is counted, not timed.
TEST(Diagnose, AnswersTheSameToTheLastBitOnAnyNumberOfThreadsOfItsOwn) {
  const std::vector<Log> logs = {ThreeLogs()[0]};
  for (const double effort : {1.0, 0.01}) {
    DiagnosisOptions options;
    options.effort = effort;
    SetNumThreads(1);
    const std::vector<double> alone = NumbersOf(Diagnose(logs, Dof::kSurge, options));
    SetNumThreads(3);
    EXPECT_EQ(NumbersOf(Diagnose(logs, Dof::kSurge, options)), alone) << effort;
  }
}

TEST(Diagnose, SaysThatItsSearchWasEnded) {
  DiagnosisOptions options;
  options.effort = 0.001;
  const std::vector<Log> logs = {ThreeLogs()[0]};
  EXPECT_THAT(Diagnose(logs, Dof::kSurge, options).remarks, Contains(HasSubstr("--effort=4")));
  EXPECT_THAT(Diagnose(logs, Dof::kSurge).remarks, Not(Contains(HasSubstr("--effort"))));
}

// The cause is found at once, and whether another does as well is what the rest of the search is
// for. A fifth of the work comes first: five times what ends too early is spent on a second search.
TEST(Diagnose, IsSureOfNoCauseThatASearchCameToWhichWasEnded) {
  SurgeRun run;
  run.input = Multisine(30.0);
  run.effects = "thrust_dead_zone:width=10";
  const std::vector<Log> logs = {LogOf(run, 1)};
  DiagnosisOptions options;
  options.effort = 0.02;
  const Diagnosis ended = Diagnose(logs, Dof::kSurge, options);
  EXPECT_EQ(TextOf(ended), "unexplained: thrust_dead_zone");
  EXPECT_TRUE(ended.is_only_cut);
  options.effort *= 5.0;
  EXPECT_EQ(TextOf(Diagnose(logs, Dof::kSurge, options)), "explained: thrust_dead_zone");
}

// A simulation without noise, of a vehicle that the catalogue knows all of.
TEST(Diagnose, LooksForNoStructureInRounding) {
  SurgeRun run;
  run.input = Multisine(30.0);
  run.velocity_noise = 0.0;
  const Diagnosis diagnosis = Diagnose(std::vector{LogOf(run, 1)}, Dof::kSurge);
  EXPECT_EQ(diagnosis.verdict, Verdict::kConsistent) << TextOf(diagnosis);
  EXPECT_THAT(diagnosis.remarks, Contains(HasSubstr("no sensor noise")));
  run.velocity_noise = 0.01;
  EXPECT_THAT(Diagnose(std::vector{LogOf(run, 1)}, Dof::kSurge).remarks,
              Not(Contains(HasSubstr("no sensor noise"))));
}

// Sums in another order differ in their last bits, and a fit ends 0.01 of chi squared from its
// optimum: 0.1 standard deviations.
void ExpectSame(const Diagnosis& a, const Diagnosis& b) {
  EXPECT_EQ(TextOf(a), TextOf(b));
  ASSERT_EQ(a.extended.covariance.rows(), b.extended.covariance.rows());
  EXPECT_NEAR(a.extended.weighed_log_likelihood, b.extended.weighed_log_likelihood, 0.5);
  int i = 0;
  const auto expect_near = [&](double x, double y) {
    EXPECT_NEAR(x, y, 0.2 * std::sqrt(a.extended.covariance(i, i))) << i;
    ++i;
  };
  expect_near(a.extended.model.baseline.inertia, b.extended.model.baseline.inertia);
  expect_near(a.extended.model.baseline.quadratic_damping,
              b.extended.model.baseline.quadratic_damping);
  expect_near(a.extended.model.baseline.linear_damping, b.extended.model.baseline.linear_damping);
  expect_near(a.extended.model.baseline.buoyancy, b.extended.model.baseline.buoyancy);
  for (size_t k = 0; k < a.extended.model.effects.size(); ++k) {
    const auto& values = a.extended.model.effects[k].values;
    for (size_t j = 0; j < values.size(); ++j) {
      expect_near(values[j], b.extended.model.effects[k].values[j]);
    }
  }
}

TEST(Diagnose, AnswersTheSameInAnyOrderOfLogs) {
  std::vector<Log> logs = ThreeLogs();
  const Diagnosis first = Diagnose(logs, Dof::kSurge);
  const auto groups = GroupsOf(first);
  ASSERT_EQ(groups.size(), 2u) << TextOf(first);
  EXPECT_EQ(groups[0].members.count("thrust_dead_zone"), 1u) << TextOf(first);
  EXPECT_EQ(groups[1].members.count("thruster_lag"), 1u) << TextOf(first);
  std::rotate(logs.begin(), logs.begin() + 1, logs.end());
  ExpectSame(first, Diagnose(logs, Dof::kSurge));
  std::reverse(logs.begin(), logs.end());
  ExpectSame(first, Diagnose(logs, Dof::kSurge));
}

TEST(Diagnose, AnswersTheSameInAnyOrderOfCandidates) {
  const std::vector<Log> logs = {ThreeLogs()[0]};
  DiagnosisOptions options;
  options.effects.assign(EffectCatalogue().begin(), EffectCatalogue().end());
  const Diagnosis first = Diagnose(logs, Dof::kSurge, options);
  std::reverse(options.effects.begin(), options.effects.end());
  ExpectSame(first, Diagnose(logs, Dof::kSurge, options));
  std::rotate(options.effects.begin(), options.effects.begin() + 11, options.effects.end());
  ExpectSame(first, Diagnose(logs, Dof::kSurge, options));
}

}  // namespace
}  // namespace fathom
