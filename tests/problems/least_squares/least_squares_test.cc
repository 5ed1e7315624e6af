// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/least_squares/least_squares.h"

#include "fathom/base/input_error.h"
#include "fathom/log/csv/csv_table.h"
#include "fathom/log/log.h"
#include "fathom/signal/signals.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <random>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr UncoupledModel<double> kTruth = {851.05, 62.0, 39.57, -0.81};

// Velocity and acceleration of a chosen motion, and the force that (1) of docs/models.md then
// needs: exact data without any integration.
Segment AnalyticSegment(const UncoupledModel<double>& model,
                        int n,
                        const std::function<double(double)>& velocity,
                        const std::function<double(double)>& acceleration) {
  Segment segment;
  for (int i = 0; i < n; ++i) {
    const double t = 0.1 * i;
    const double v = velocity(t), a = acceleration(t);
    segment.time.push_back(t);
    segment.velocity.push_back(v);
    segment.smoothed_velocity.push_back(v);
    segment.acceleration.push_back(a);
    segment.smoothed_force.push_back(model.inertia * a + model.quadratic_damping * v * std::abs(v) +
                                     model.linear_damping * v + model.buoyancy);
  }
  return segment;
}

Segment RichSegment(int n = 2000) {
  return AnalyticSegment(
      kTruth,
      n,
      [](double t) { return 0.4 * std::sin(0.3 * t) + 0.25 * std::sin(0.71 * t + 1.0) + 0.05; },
      [](double t) { return 0.12 * std::cos(0.3 * t) + 0.25 * 0.71 * std::cos(0.71 * t + 1.0); });
}

TEST(LeastSquares, RecoversTheTruthFromPerfectData) {
  const std::vector<Segment> segments = {RichSegment()};
  const auto summary = FitLeastSquares(segments);
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  // Rounding times the condition number, with room.
  EXPECT_NEAR(summary.model.inertia, kTruth.inertia, 1e-9);
  EXPECT_NEAR(summary.model.quadratic_damping, kTruth.quadratic_damping, 1e-9);
  EXPECT_NEAR(summary.model.linear_damping, kTruth.linear_damping, 1e-9);
  EXPECT_NEAR(summary.model.buoyancy, kTruth.buoyancy, 1e-9);
  EXPECT_EQ(summary.num_samples, 2000);
  EXPECT_THAT(summary.caveats, Contains(HasSubstr("do not cover")));
}

TEST(LeastSquares, LeavesOutSamplesWithoutAnAcceleration) {
  Segment segment = RichSegment();
  for (int i = 0; i < 30; ++i) segment.acceleration[i] = std::nan("");
  segment.smoothed_force[700] = std::nan("");
  const auto summary = FitLeastSquares(std::vector<Segment>{segment});
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  EXPECT_EQ(summary.num_samples, 2000 - 31);
  EXPECT_NEAR(summary.model.inertia, kTruth.inertia, 1e-9);
}

// Numbers of another program (numpy, full-rank least squares and singular values) on a real log.
TEST(LeastSquares, AgreesWithTheReferenceOnARealLog) {
  const char* const folder = std::getenv("FATHOM_REALDATA");
  const std::filesystem::path real =
      folder != nullptr ? folder : FATHOM_SOURCE_DIR "/../shared/realdata";
  const auto path = real / "lbv_surge" / "author_velocity.csv";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there.";
  CsvSpec spec;
  spec.required = {"u", "du", "tau_surge_shifted"};
  const CsvTable table = ReadCsvTable(path, spec);
  Segment segment;
  segment.time = table.stream.time;
  segment.velocity = *table.stream.Find("u");
  segment.smoothed_velocity = segment.velocity;
  segment.acceleration = *table.stream.Find("du");
  segment.smoothed_force = *table.stream.Find("tau_surge_shifted");
  const auto summary = FitLeastSquares(std::vector<Segment>{segment});
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  EXPECT_NEAR(summary.model.inertia, 12.682969932550177, 1e-9);
  EXPECT_NEAR(summary.model.quadratic_damping, 0.6234309693453235, 1e-9);
  EXPECT_NEAR(summary.model.linear_damping, 3.5822795422605975, 1e-9);
  EXPECT_NEAR(summary.model.buoyancy, -0.006051181354342848, 1e-9);
}

// The reported covariance is a promise about the spread over repeated runs. Noise of the
// acceleration as an autoregression of order one; rho 0 is white.
class LeastSquaresCovariance : public ::testing::TestWithParam<double> {};

TEST_P(LeastSquaresCovariance, MatchesTheSpreadOverRepeatedRuns) {
  const double rho = GetParam(), sigma = 0.01;
  const int num_runs = 300;
  const Segment perfect = RichSegment(1500);
  std::mt19937 generator(7);
  std::normal_distribution<double> normal;
  Eigen::Vector4d sum_of_squared_z = Eigen::Vector4d::Zero();
  for (int run = 0; run < num_runs; ++run) {
    Segment segment = perfect;
    double e = sigma * normal(generator);
    for (double& a : segment.acceleration) {
      a += e;
      e = rho * e + sigma * std::sqrt(1.0 - rho * rho) * normal(generator);
    }
    const auto summary = FitLeastSquares(std::vector<Segment>{segment});
    ASSERT_TRUE(summary.IsUsable()) << summary.message;
    const Eigen::Vector4d error = ToVector(summary.model) - ToVector(kTruth);
    sum_of_squared_z += error.cwiseAbs2().cwiseQuotient(summary.covariance.diagonal());
  }
  for (int k = 0; k < 4; ++k) {
    // Mean of chi-square variables: 1, give or take sqrt(2 / num_runs); the noise's colour is known
    // only as well as some tens of correlation times tell it, hence the factor 1.2 on top.
    EXPECT_GT(sum_of_squared_z[k] / num_runs, (1.0 - 4.0 * std::sqrt(2.0 / num_runs)) / 1.2) << k;
    EXPECT_LT(sum_of_squared_z[k] / num_runs, (1.0 + 4.0 * std::sqrt(2.0 / num_runs)) * 1.2) << k;
  }
}

INSTANTIATE_TEST_SUITE_P(WhiteAndColoured, LeastSquaresCovariance, ::testing::Values(0.0, 0.9));

TEST(LeastSquares, NamesWhatASteadySpeedLeavesOpen) {
  const auto segment = AnalyticSegment(
      kTruth, 500, [](double) { return 0.3; }, [](double) { return 0.0; });
  const auto summary = FitLeastSquares(std::vector<Segment>{segment});
  EXPECT_FALSE(summary.IsUsable());
  EXPECT_TRUE(std::isnan(summary.model.inertia));
  EXPECT_THAT(summary.message, HasSubstr("do not determine"));
  EXPECT_THAT(summary.not_determined,
              ElementsAre("inertia", "quadratic_damping", "linear_damping", "buoyancy"));
}

// At one speed's magnitude, v|v| and v are the same column.
TEST(LeastSquares, NamesTheDampingsThatOneSpeedCannotTellApart) {
  Segment segment;
  for (int i = 0; i < 400; ++i) {
    const double v = (i / 50) % 2 == 0 ? 0.3 : -0.3;
    const double a = 0.1 * std::sin(0.37 * i);
    segment.smoothed_velocity.push_back(v);
    segment.acceleration.push_back(a);
    segment.smoothed_force.push_back(900.0 * a + 40.0 * v);
  }
  const auto summary = FitLeastSquares(std::vector<Segment>{segment});
  EXPECT_FALSE(summary.IsUsable());
  EXPECT_THAT(summary.not_determined, ElementsAre("quadratic_damping", "linear_damping"));
}

TEST(LeastSquares, RefusesForceAgainstAcceleration) {
  Segment segment = RichSegment();
  for (double& force : segment.smoothed_force) force = -force;
  const auto summary = FitLeastSquares(std::vector<Segment>{segment});
  EXPECT_FALSE(summary.IsUsable());
  EXPECT_TRUE(std::isnan(summary.model.inertia));
  EXPECT_THAT(summary.message, HasSubstr("-851"));
  EXPECT_THAT(summary.message, HasSubstr("opposite"));
}

TEST(LeastSquares, RefusesAnAccelerationThatTheForceDoesNotExplain) {
  Segment segment = RichSegment();
  std::mt19937 generator(3);
  std::normal_distribution<double> normal(0.0, 50.0);
  for (double& a : segment.acceleration) a += normal(generator);
  const auto summary = FitLeastSquares(std::vector<Segment>{segment});
  EXPECT_FALSE(summary.IsUsable());
  EXPECT_FALSE(summary.message.empty());
}

TEST(LeastSquares, SaysThatNegativeDampingIsUnphysical) {
  const UncoupledModel<double> truth = {1511.53, 1911.21, -70.29, -12.42};  // the paper's heave
  const auto segment = AnalyticSegment(
      truth,
      2000,
      [](double t) { return 0.3 * std::sin(0.3 * t) + 0.1 * std::sin(0.9 * t); },
      [](double t) { return 0.09 * std::cos(0.3 * t) + 0.09 * std::cos(0.9 * t); });
  const auto summary = FitLeastSquares(std::vector<Segment>{segment});
  ASSERT_TRUE(summary.IsUsable()) << summary.message;
  EXPECT_NEAR(summary.model.linear_damping, -70.29, 1e-8);
  EXPECT_THAT(summary.caveats, Contains(HasSubstr("linear_damping is negative")));
}

TEST(LeastSquares, RefusesDataWithoutAccelerations) {
  const auto summary = FitLeastSquares(std::vector<Segment>{Segment{}});
  EXPECT_FALSE(summary.IsUsable());
  EXPECT_THAT(summary.message, HasSubstr("Only 0 samples"));
  EXPECT_FALSE(LeastSquaresSummary{}.IsUsable());
}

TEST(LeastSquares, NamesEveryBrokenRuleOfItsOptions) {
  const LeastSquaresOptions options = {.smallest_singular_value = 1.5, .max_noise_order = -1};
  EXPECT_EQ(options.Problems().size(), 2u);
  EXPECT_THROW(FitLeastSquares({}, options), InputError);
}

}  // namespace
}  // namespace fathom
