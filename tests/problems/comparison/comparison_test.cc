// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/comparison/comparison.h"

#include "fathom/comparison/recommendation.h"

#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include "error_from.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr UncoupledModel<double> kTruth = {
    .inertia = 40.0, .quadratic_damping = 30.0, .linear_damping = 5.0, .buoyancy = 1.0};

double ForceAt(double t) { return 12.0 * std::sin(0.31 * t + 0.4) + 9.0 * std::sin(1.3 * t + 2.0); }

// 200 s of surge at 10 Hz, the last 50 s held out: velocity with noise of 0.01 m/s, position with
// 0.005 m. Explicit Euler of 0.2 ms, the force held for 0.1 s.
Log KnownRun(const std::string& name = "known_run", unsigned seed = 3, double inertia = 40.0) {
  UncoupledModel<double> model = kTruth;
  model.inertia = inertia;
  Log log;
  log.path = name;
  log.name = "known_run";
  log.dofs = {Dof::kSurge};
  log.held_out = {{150.0, 200.05}};
  log.command.emplace();
  log.command->columns = {"tau_surge"};
  log.command->values.resize(1);
  log.velocity.emplace();
  log.velocity->columns = {"u"};
  log.velocity->values.resize(1);
  log.pose.emplace();
  log.pose->columns = {"x", "y", "z", "qx", "qy", "qz", "qw"};
  log.pose->values.resize(7);
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  double v = 0.0, x = -2.0;
  for (int i = 0; i <= 2000; ++i) {
    const double t = 0.1 * i;
    const double force = ForceAt(t);
    log.command->time.push_back(t);
    log.command->values[0].push_back(force);
    log.velocity->time.push_back(t);
    log.velocity->values[0].push_back(v + 0.01 * normal(generator));
    log.pose->time.push_back(t);
    const double pose[] = {x + 0.005 * normal(generator), 0.3, -0.2, 0.0, 0.0, 0.0, 1.0};
    for (int k = 0; k < 7; ++k) log.pose->values[k].push_back(pose[k]);
    for (int k = 0; k < 500; ++k) {
      x += 2e-4 * v;
      v += 2e-4 * model.Acceleration(v, force);
    }
  }
  return log;
}

ComparisonOptions Only(Family family) {
  ComparisonOptions options;
  options.families = {family};
  return options;
}

double StdOf(const Identification& row, int parameter) {
  return std::sqrt(row.fitted.covariance(parameter, parameter));
}

Comparison CompareOne(const Log& log, const ComparisonOptions& options = {}) {
  return Compare({&log, 1}, options);
}

std::string RefusalOf(const Log& log, const ComparisonOptions& options) {
  return ErrorFrom([&] { Compare({&log, 1}, options); });
}

TEST(Compare, TriesEveryFamilyOnEverySource) {
  const Comparison comparison = CompareOne(KnownRun());
  EXPECT_EQ(comparison.log_name, "known_run");
  ASSERT_EQ(comparison.dofs.size(), 1u);
  const auto& rows = comparison.dofs[0].rows;
  ASSERT_EQ(rows.size(), 6u);
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(rows[i].family, kSignalFamilies[i % 3]);
    EXPECT_EQ(rows[i].source, i < 3 ? Source::kPoseEstimator : Source::kCamera);
    EXPECT_TRUE(rows[i].is_usable) << i << ": " << rows[i].message;
  }
}

TEST(Compare, OutputErrorFindsTheTruthWithinItsIntervalsFromBothSources) {
  const Comparison comparison = CompareOne(KnownRun(), Only(Family::kOutputError));
  const ParameterVector truth = ToVector(kTruth);
  ASSERT_EQ(comparison.dofs.at(0).rows.size(), 2u);
  for (const Identification& row : comparison.dofs[0].rows) {
    ASSERT_TRUE(row.is_usable) << row.message;
    const ParameterVector found = ToVector(row.fitted.model);
    for (int i = 0; i < kNumParameters; ++i) {
      const double std = std::sqrt(row.fitted.covariance(i, i));
      // Eight numbers: one beyond 4 standard deviations in 2000 seeds.
      EXPECT_NEAR(found[i], truth[i], 4.0 * std) << kParameterInfo[i].name;
      // And the intervals are of use.
      if (i != kBuoyancy) {
        EXPECT_LT(std, 0.15 * truth[i]) << kParameterInfo[i].name;
      }
    }
  }
}

// The measured noise of 0.01 m/s is 0.01 sqrt(2 / pi) in the mean: no model's MAE can be below, and
// that of the true model is there. A camera model's too, since both are scored on the velocity.
TEST(Compare, ScoresAllSourcesOnTheVelocity) {
  const Comparison comparison = CompareOne(KnownRun(), Only(Family::kOutputError));
  const double noise = 0.01 * std::sqrt(2.0 / M_PI);
  for (const Identification& row : comparison.dofs.at(0).rows) {
    // 500 held-out samples know their mean to 0.01 / sqrt(500) x 0.6; the run's start adds some.
    EXPECT_NEAR(row.fitted.held_out.mae, noise, 0.0015) << Name(row.source);
    EXPECT_EQ(row.fitted.held_out.num_samples + row.fitted.train.num_samples, 2001);
  }
}

// White noise of 0.01 m/s over the mean speed held out: known from 500 samples to 4 %.
TEST(Compare, KnowsWhatNoiseAloneGives) {
  const Log log = KnownRun();
  const Comparison comparison = Compare({&log, 1}, Only(Family::kOutputError));
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < log.velocity->time.size(); ++i) {
    if (!log.held_out.front().Contains(log.velocity->time[i])) continue;
    sum += std::abs(log.velocity->values[0][i]);
    ++count;
  }
  const double noise = 0.01 * std::sqrt(2.0 / M_PI) / (sum / count);
  EXPECT_NEAR(NoiseNmae(comparison.dofs.at(0)), noise, 0.12 * noise);
  EXPECT_LT(NoiseNmae(comparison.dofs[0]),
            1.1 * ScoreOf(comparison.dofs[0], comparison.dofs[0].rows[0]));
}

TEST(Compare, TakesTheFamiliesSourcesAndDofsItIsAskedFor) {
  ComparisonOptions options = Only(Family::kLeastSquares);
  options.dofs = {Dof::kSurge};
  options.sources = {Source::kCamera};
  const Comparison comparison = CompareOne(KnownRun(), options);
  ASSERT_EQ(comparison.dofs.at(0).rows.size(), 1u);
  EXPECT_EQ(comparison.dofs[0].rows[0].family, Family::kLeastSquares);
  EXPECT_EQ(comparison.dofs[0].rows[0].source, Source::kCamera);
}

// Four runs know twice as much as one: half the standard deviation, and the truth within it.
TEST(Compare, FitsSeveralLogsTogether) {
  const std::vector<Log> logs = {
      KnownRun("a", 3), KnownRun("b", 4), KnownRun("c", 5), KnownRun("d", 6)};
  const Comparison together = Compare(logs, Only(Family::kOutputError));
  const Comparison alone = Compare({&logs.front(), 1}, Only(Family::kOutputError));
  EXPECT_EQ(together.log_name, "known_run, known_run, known_run, known_run");
  EXPECT_THAT(together.dofs.at(0).log_of_train, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(together.dofs[0].log_of_held_out, ElementsAre(0, 1, 2, 3));
  const ParameterVector truth = ToVector(kTruth);
  ASSERT_EQ(together.dofs[0].rows.size(), 2u);
  for (int k = 0; k < 2; ++k) {
    const Identification& row = together.dofs[0].rows[k];
    ASSERT_TRUE(row.is_usable) << row.message;
    EXPECT_EQ(row.fitted.held_out.num_samples + row.fitted.train.num_samples, 4 * 2001);
    const ParameterVector found = ToVector(row.fitted.model);
    for (int i = 0; i < kNumParameters; ++i) {
      EXPECT_NEAR(found[i], truth[i], 4.0 * StdOf(row, i)) << kParameterInfo[i].name;
      // Chance differences of four runs may widen it: by 2 once in 1000 draws.
      EXPECT_GT(StdOf(row, i), 0.4 * StdOf(alone.dofs[0].rows[k], i)) << kParameterInfo[i].name;
      EXPECT_LT(StdOf(row, i), StdOf(alone.dofs[0].rows[k], i)) << kParameterInfo[i].name;
    }
  }
}

// Two vehicles of 40 and 48 kg: no interval of a few grams is true of both.
TEST(Compare, WidensTheIntervalsOfLogsThatDiffer) {
  const std::vector<Log> logs = {KnownRun("light", 3, 40.0), KnownRun("heavy", 4, 48.0)};
  const Comparison comparison = Compare(logs, Only(Family::kOutputError));
  const Identification& row = comparison.dofs.at(0).rows.at(0);
  ASSERT_TRUE(row.is_usable) << row.message;
  EXPECT_NEAR(row.fitted.model.inertia, 44.0, 2.0);
  EXPECT_NEAR(StdOf(row, kInertia), 4.0, 1.5);  // 8 kg apart: their mean is known to half of it
  EXPECT_THAT(row.fitted.caveats, Contains(HasSubstr("inertia")));
}

TEST(Compare, TakesWhatAllLogsHave) {
  std::vector<Log> logs = {KnownRun("a", 3), KnownRun("b", 4)};
  logs[0].dofs = {Dof::kYaw, Dof::kSurge};
  logs[1].pose.reset();
  const Comparison comparison = Compare(logs, Only(Family::kLeastSquares));
  ASSERT_EQ(comparison.dofs.size(), 1u);
  EXPECT_EQ(comparison.dofs[0].dof, Dof::kSurge);
  ASSERT_EQ(comparison.dofs[0].rows.size(), 1u);
  EXPECT_EQ(comparison.dofs[0].rows[0].source, Source::kPoseEstimator);
}

TEST(Compare, RefusesLogsWithoutADofOrASourceInCommon) {
  const auto refusal = [](const std::vector<Log>& logs) -> std::string {
    return ErrorFrom([&] { Compare(logs); });
  };
  std::vector<Log> logs = {KnownRun("a"), KnownRun("b")};
  logs[0].pose.reset();
  logs[1].velocity.reset();
  EXPECT_EQ(refusal(logs),
            "a and the logs beside it have no source of surge in common: some have it in "
            "velocity.csv alone, others in pose.csv.");
  logs[1].dofs = {Dof::kYaw};
  EXPECT_EQ(refusal(logs),
            "a and the logs beside it name no dof in common; say which with --dofs.");
  EXPECT_EQ(refusal({}), "A comparison needs at least one log.");
}

TEST(Compare, RefusesADofThatNothingMeasures) {
  Log log = KnownRun();
  log.pose.reset();
  ComparisonOptions options;
  options.dofs = {Dof::kHeave};
  const std::string message = RefusalOf(log, options);
  EXPECT_THAT(message, HasSubstr("known_run"));
  EXPECT_THAT(message, HasSubstr("heave"));
  EXPECT_THAT(message, HasSubstr("'w'"));
}

TEST(Compare, AsksForADofWhereTheLogNamesNone) {
  Log log = KnownRun();
  log.dofs.clear();
  EXPECT_THAT(RefusalOf(log, {}), HasSubstr("--dofs"));
}

TEST(Compare, RefusesASourceThatTheLogDoesNotHold) {
  Log log = KnownRun();
  log.pose.reset();
  ComparisonOptions options;
  options.sources = {Source::kCamera};
  EXPECT_THAT(RefusalOf(log, options), HasSubstr("pose.csv"));
}

TEST(Compare, RefusesAJointRefinementWithoutCornersOrCamera) {
  ComparisonOptions options = Only(Family::kJoint);
  EXPECT_THAT(RefusalOf(KnownRun(), options), HasSubstr("holds no detections.csv"));
  options.sources = {Source::kPoseEstimator};
  EXPECT_THAT(RefusalOf(KnownRun(), options), HasSubstr("source camera"));
}

// Nothing moves: there is nothing to learn, and no family may claim to have learnt it.
TEST(Identify, AVehicleAtRestGivesNoUsableModelAndAReason) {
  Log log = KnownRun();
  for (double& force : log.command->values[0]) force = 0.0;
  for (double& speed : log.velocity->values[0]) speed = 0.0;
  const Signals signals = SignalsOf(log, Dof::kSurge);
  for (const Family family : kSignalFamilies) {
    const Identification result = Identify(signals, signals, family);
    EXPECT_FALSE(result.is_usable) << Name(family);
    EXPECT_FALSE(result.message.empty()) << Name(family);
    EXPECT_TRUE(std::isnan(result.fitted.train.nmae)) << Name(family);
    EXPECT_TRUE(std::isnan(result.fitted.held_out.nmae)) << Name(family);
  }
}

}  // namespace
}  // namespace fathom
