// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/adaptive/fit_adaptive.h"

#include "fathom/adaptive/choose_gains.h"
#include "fathom/base/input_error.h"
#include "fathom/log/csv/csv_table.h"

#include <chrono>
#include <cmath>
#include <type_traits>

#include "experiments.h"
#include "real_data.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

const AdaptiveGains kAuthorsGains = {-0.005, {0.5, 0.5, 0.5, 0.05}};

// docs/adaptive.md (3) with a period of 21 s, 37 N and 0.15 m/s; 7 N m and 0.06 rad/s.
const AdaptiveGains kSurgeGains = {-0.0997, {1.09e-5, 19.6, 0.663, 0.0149}};
const AdaptiveGains kYawGains = {-0.0997, {3.04e-4, 767.0, 4.14, 0.0149}};

Experiment RichAndPerfect() {
  Experiment experiment = FlatFishSurge();
  experiment.truth = {851.05, 120.0, 39.57, -3.0};
  experiment.force = [](double t, double, double) {
    return 60.0 * std::sin(0.11 * t) + 60.0 * std::sin(0.3 * t + 1.0) +
           60.0 * std::sin(0.83 * t + 2.0);
  };
  experiment.noise = 0.0;
  experiment.duration = 1200.0;
  return experiment;
}

// One Euler step written out by hand: h 0.5, from v_hat 0 and Phi 0.
TEST(AdaptiveIdentifier, TakesTheEulerStepsOfThePaper) {
  AdaptiveIdentifier identifier({.gains = AdaptiveGains{-0.2, {0.3, 0.4, 0.5, 0.6}},
                                 .integrator = AdaptiveIntegrator::kEuler});
  EXPECT_TRUE(std::isnan(identifier.Estimate().inertia));
  identifier.Add(10.0, 2.0, 0.7);
  // dv = -0.7, f = (2, 0, 0, 1): v_hat' = 0.14; Phi' = (0.42, 0, 0, 0.42).
  identifier.Add(10.5, -1.0, 0.9);
  EXPECT_NEAR(identifier.velocity(), 0.07, 1e-15);
  EXPECT_NEAR(identifier.lumped()[0], 0.21, 1e-15);
  EXPECT_NEAR(identifier.lumped()[3], 0.21, 1e-15);
  // dv = -0.83, f = (-1, 0.0049, 0.07, 1): v_hat' = 0.166 - 0.21 + 0.21 = 0.166,
  // Phi' = 0.83 (-0.3, 0.4 * 0.0049, 0.5 * 0.07, 0.6).
  identifier.Add(11.5, 0.0, 0.0);
  EXPECT_NEAR(identifier.velocity(), 0.236, 1e-15);
  EXPECT_NEAR(identifier.lumped()[0], 0.21 - 0.249, 1e-15);
  EXPECT_NEAR(identifier.Estimate().inertia, 1e5, 1e-6) << "where alpha is not positive";
  EXPECT_NEAR(identifier.lumped()[1], 0.83 * 0.4 * 0.0049, 1e-15);
  EXPECT_NEAR(identifier.lumped()[2], 0.83 * 0.5 * 0.07, 1e-15);
  EXPECT_NEAR(identifier.lumped()[3], 0.708, 1e-15);
  EXPECT_EQ(identifier.num_samples(), 3);
}

// The author's own run on a real log, one pass; see its reference.json.
using AdaptiveIdentifierOnRealData = OnRealData;
TEST_F(AdaptiveIdentifierOnRealData, ReplaysTheAuthorsRun) {
  const auto path = folder_ / "lbv_surge" / "author_velocity.csv";
  CsvSpec spec;
  spec.required = {"u", "tau_surge_shifted"};
  const Stream stream = ReadCsvTable(path, spec).stream;
  const auto &u = *stream.Find("u"), &tau = *stream.Find("tau_surge_shifted");
  AdaptiveIdentifier identifier({.gains = kAuthorsGains, .integrator = AdaptiveIntegrator::kEuler});
  // His record begins with the second sample.
  for (size_t i = 1; i < u.size(); ++i) identifier.Add(stream.time[i], tau[i], u[i]);
  const auto model = identifier.Estimate();
  EXPECT_NEAR(model.inertia, 14.874438852929558, 1e-6);
  EXPECT_NEAR(model.quadratic_damping, 0.4795081841647953, 1e-7);
  EXPECT_NEAR(model.linear_damping, 4.346771816699996, 1e-7);
  EXPECT_NEAR(model.buoyancy, -0.023562092477141756, 1e-8);
}

// Both integrators solve the same equations.
TEST(AdaptiveIdentifier, ConvergesWithTheStepAsItsIntegratorPromises) {
  const AdaptiveGains gains = {-0.3, {1e-4, 2.0, 0.5, 0.05}};
  // alpha every second. The force steps on whole seconds and the velocity is linear in between, so
  // that the assumptions of Runge-Kutta hold exactly.
  const auto run = [&](AdaptiveIntegrator integrator, int per_second) {
    AdaptiveIdentifier identifier({.gains = gains, .integrator = integrator});
    std::vector<double> alpha;
    for (int i = 0; i <= 60 * per_second; ++i) {
      const int second = i / per_second;
      const double t = static_cast<double>(i) / per_second, share = t - second;
      const auto v = [](int k) { return 0.5 * std::sin(0.3 * k); };
      identifier.Add(
          t, second % 7 < 3 ? 30.0 : -20.0, (1.0 - share) * v(second) + share * v(second + 1));
      if (i % per_second == 0) alpha.push_back(identifier.lumped()[0]);
    }
    return alpha;
  };
  const auto truth = run(AdaptiveIntegrator::kRungeKutta, 64);
  const auto error = [&](AdaptiveIntegrator integrator, int per_second) {
    const auto alpha = run(integrator, per_second);
    double largest = 0.0;
    for (size_t i = 0; i < truth.size(); ++i) {
      largest = std::max(largest, std::abs(alpha[i] - truth[i]));
    }
    return largest;
  };
  const double runge_kutta = error(AdaptiveIntegrator::kRungeKutta, 2);
  const double euler = error(AdaptiveIntegrator::kEuler, 8);
  // Half the step: a sixteenth of the error of order four, half of order one.
  EXPECT_NEAR(std::log2(runge_kutta / error(AdaptiveIntegrator::kRungeKutta, 4)), 4.0, 0.5);
  EXPECT_NEAR(std::log2(euler / error(AdaptiveIntegrator::kEuler, 16)), 1.0, 0.3);
  EXPECT_GT(euler, 10.0 * runge_kutta) << "even with a fourth of the step";
}

TEST(AdaptiveIdentifier, RecoversTheTruthFromRichPerfectData) {
  const Segment segment = RunOf(RichAndPerfect(), 0);
  const auto truth = RichAndPerfect().truth;
  const auto summary = FitAdaptive(std::vector<Segment>{segment});
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  // What the law has not forgotten of its start after 1200 s.
  EXPECT_NEAR(summary.model.inertia, truth.inertia, 0.005 * truth.inertia);
  EXPECT_NEAR(summary.model.quadratic_damping, truth.quadratic_damping, 5.0);
  EXPECT_NEAR(summary.model.linear_damping, truth.linear_damping, 2.0);
  EXPECT_NEAR(summary.model.buoyancy, truth.buoyancy, 0.2);
}

TEST(AdaptiveIdentifier, DoesNotDisturbOtherInstances) {
  const Segment surge = RunOf(FlatFishSurge(), 1), yaw = RunOf(FlatFishYaw(), 2);
  const AdaptiveOptions first = {.gains = kSurgeGains};
  const AdaptiveOptions second = {.gains = kYawGains};
  const auto alone = [](const AdaptiveOptions& options, const Segment& segment) {
    AdaptiveIdentifier identifier(options);
    for (size_t i = 0; i < segment.time.size(); ++i) {
      identifier.Add(segment.time[i], segment.command.value[i], segment.velocity[i]);
    }
    return identifier.lumped();
  };
  AdaptiveIdentifier a(first), b(second), a_again(first);
  for (size_t i = 0; i < surge.time.size(); ++i) {
    a.Add(surge.time[i], surge.command.value[i], surge.velocity[i]);
    b.Add(yaw.time[i], yaw.command.value[i], yaw.velocity[i]);
    if (i % 2 == 0) a_again.Add(surge.time[i], surge.command.value[i], surge.velocity[i]);
  }
  EXPECT_EQ(a.lumped(), alone(first, surge));
  EXPECT_EQ(b.lumped(), alone(second, yaw));
  EXPECT_NE(a_again.lumped(), a.lumped());
}

// No pointer, no container: what an identifier knows is what it is made of, for any stream.
static_assert(std::is_trivially_copyable_v<AdaptiveIdentifier>);
static_assert(sizeof(AdaptiveIdentifier) < 200);

TEST(AdaptiveIdentifier, KeepsItsParametersAcrossSegments) {
  const Segment segment = RunOf(FlatFishSurge(), 1);
  AdaptiveIdentifier identifier({.gains = kSurgeGains});
  for (int i = 0; i < 1000; ++i) {
    identifier.Add(segment.time[i], segment.command.value[i], segment.velocity[i]);
  }
  const auto before = identifier.lumped();
  identifier.StartSegment();
  identifier.Add(segment.time[0], segment.command.value[0], 0.123);  // stamps may go back
  EXPECT_EQ(identifier.lumped(), before);
  EXPECT_EQ(identifier.velocity(), 0.123);
}

TEST(AdaptiveIdentifier, RefusesGainsThatBreakTheirRules) {
  EXPECT_THROW(AdaptiveIdentifier(AdaptiveOptions{}), InputError);
  const AdaptiveGains wrong = {0.1, {0.5, -0.5, 0.0, 0.05}};
  // By the words of --gains=a_m,l1,l2,l3,l4.
  EXPECT_THAT(wrong.Problems(),
              testing::ElementsAre("a_m is 0.1, expected a number below 0",
                                   "l2 is -0.5, expected a number above 0",
                                   "l3 is 0, expected a number above 0"));
  EXPECT_EQ(AdaptiveGains{}.Problems().size(), 5u);
  EXPECT_THROW(AdaptiveIdentifier({.gains = wrong}), InputError);
  EXPECT_THROW(FitAdaptive({}, {.gains = wrong}), InputError);
}

// The acceptance of the automatic gains: the inertia within 5 % in one pass, without tuning.
struct Case {
  const char* name;
  Experiment experiment;
};

class ChosenGains : public ::testing::TestWithParam<Case> {};

TEST_P(ChosenGains, FindTheInertiaInOnePass) {
  const Experiment& experiment = GetParam().experiment;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const std::vector<Segment> segments = {RunOf(experiment, seed)};
    const auto summary = FitAdaptive(segments);
    ASSERT_TRUE(summary.IsUsable()) << summary.message;
    EXPECT_TRUE(summary.gains.Problems().empty());
    // 60 seeds spread by 1.2 % rms, 2.7 % at most.
    EXPECT_NEAR(summary.model.inertia, experiment.truth.inertia, 0.05 * experiment.truth.inertia)
        << "seed " << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(FlatFish,
                         ChosenGains,
                         ::testing::Values(Case{"Surge", FlatFishSurge()},
                                           Case{"Heave", FlatFishHeave()},
                                           Case{"Yaw", FlatFishYaw()}),
                         [](const auto& info) { return info.param.name; });

TEST(ChooseGains, IsDeterministicAndQuick) {
  const std::vector<Segment> segments = {RunOf(FlatFishSurge(), 3)};
  const auto begin = std::chrono::steady_clock::now();
  const AdaptiveGains first = ChooseGains(segments);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  const AdaptiveGains second = ChooseGains(segments);
  EXPECT_EQ(first.a_m, second.a_m);
  EXPECT_EQ(first.lambda, second.lambda);
  // 65 ms for 3000 samples; sanitizers and a loaded machine take their time.
  EXPECT_LT(took.count(), 5.0);
}

// The unit of the force (N or kN, or ampere) must not matter.
TEST(ChooseGains, FollowsTheUnitOfTheForce) {
  std::vector<Segment> segments = {RunOf(FlatFishSurge(), 3)};
  const double inertia = FitAdaptive(segments).model.inertia;
  for (double& value : segments[0].command.value) value *= 0.05;
  EXPECT_NEAR(FitAdaptive(segments).model.inertia, 0.05 * inertia, 1e-6 * inertia);
}

TEST(FitAdaptive, TellsWhatItsIntervalIs) {
  const std::vector<Segment> segments = {RunOf(FlatFishSurge(), 4)};
  const auto summary = FitAdaptive(segments, {.gains = kSurgeGains});
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  EXPECT_EQ(summary.num_samples, 3001);
  EXPECT_GT(summary.covariance(kInertia, kInertia), 0.0);
  EXPECT_THAT(summary.caveats, Contains(HasSubstr("do not cover")));
}

TEST(FitAdaptive, GoesThroughSegmentsInTheOrderOfTime) {
  const Segment whole = RunOf(FlatFishSurge(), 4);
  const auto cut = [&](size_t begin, size_t end) {
    Segment part;
    part.time.assign(whole.time.begin() + begin, whole.time.begin() + end);
    part.velocity.assign(whole.velocity.begin() + begin, whole.velocity.begin() + end);
    part.command = whole.command;
    return part;
  };
  const std::vector<Segment> forwards = {cut(0, 1500), cut(1500, 3001)};
  const std::vector<Segment> backwards = {forwards[1], forwards[0]};
  const AdaptiveOptions options = {.gains = kSurgeGains};
  EXPECT_EQ(FitAdaptive(forwards, options).model.inertia,
            FitAdaptive(backwards, options).model.inertia);
}

TEST(FitAdaptive, RefusesAForceWithTheWrongSign) {
  std::vector<Segment> segments = {RunOf(FlatFishSurge(), 1)};
  for (double& value : segments[0].command.value) value = -value;
  const auto summary = FitAdaptive(segments);
  EXPECT_FALSE(summary.IsUsable());
  EXPECT_TRUE(std::isnan(summary.model.inertia));
  EXPECT_THAT(summary.message, Not(HasSubstr("not called")));
}

TEST(FitAdaptive, RefusesDataThatHoldNothing) {
  EXPECT_FALSE(FitAdaptive({}).IsUsable());
  Segment still = RunOf(FlatFishSurge(), 1);
  for (double& value : still.command.value) value = 0.0;
  const auto summary = FitAdaptive(std::vector<Segment>{still});
  EXPECT_FALSE(summary.IsUsable());
  EXPECT_THAT(summary.message, HasSubstr("No gains"));
  EXPECT_FALSE(AdaptiveSummary{}.IsUsable());
}

TEST(FitAdaptive, SaysThatItDiverged) {
  const auto summary = FitAdaptive(std::vector<Segment>{RunOf(FlatFishSurge(), 1)},
                                   {.gains = AdaptiveGains{-1e4, {1.0, 1e6, 1e6, 1e6}}});
  EXPECT_FALSE(summary.IsUsable());
  EXPECT_THAT(summary.message, HasSubstr("diverged"));
}

}  // namespace
}  // namespace fathom
