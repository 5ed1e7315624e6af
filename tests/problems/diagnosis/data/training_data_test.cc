// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/data/training_data.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "surge_run.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr UncoupledModel<double> kVehicle = {890.0, 300.0, 10.0, 0.0};
constexpr double kHold = 60.0;  // [s] full ahead, then as long with the thrusters off

TrainingData DataOf(const UncoupledModel<double>& about) {
  SurgeRun run;
  run.model = kVehicle;
  run.input = Steps({200.0, 0.0}, kHold);
  run.duration = 6.0 * kHold;
  run.velocity_noise = 0.0003;
  return TrainingData(MeasuredSegmentsOf(std::vector<Log>{LogOf(run, 1)}, Dof::kSurge).all, about);
}

TEST(TrainingData, ASampleIsDampedAsTheVehicleIsAtItsSpeed) {
  const TrainingData data = DataOf(kVehicle);
  double mean_speed = 0.0;
  for (const double v : data.measured()) mean_speed += std::abs(v) / data.bins().size();
  const auto damping = [](double v) { return 10.0 + 600.0 * std::abs(v); };
  EXPECT_NEAR(data.DampingRate(kVehicle), damping(mean_speed) / 890.0, 1e-3 * damping(mean_speed));
  double least = 10.0, most = 0.0;
  for (int i = 1; i < data.bins().size(); ++i) {
    // Where it speeds up or coasts the mean over a bin is that of no instant.
    if (std::abs(data.measured()[i] - data.measured()[i - 1]) > 0.003) continue;
    const double expected = std::max(damping(data.measured()[i]) / damping(mean_speed), 0.125);
    const double factor = data.samples()[i].damping_factor;
    EXPECT_NEAR(std::log2(factor), std::log2(expected), 0.125 + 0.05) << expected;  // grid, noise
    least = std::min(least, factor);
    most = std::max(most, factor);
  }
  EXPECT_LT(least, 0.3);
  EXPECT_GT(most, 1.5);
}

TEST(TrainingData, IsDampedEvenlyAboutAModelWithoutDamping) {
  const TrainingData data = DataOf({});
  for (const NoiseSample& sample : data.samples()) EXPECT_EQ(sample.damping_factor, 1.0);
}

// How the vehicle's speed differs from its undisturbed one at the samples, a force wandering with
// `noise.disturbance` all the while: Euler's method, with no code of the library.
Eigen::VectorXd Disturbed(const TrainingData& data, const NoiseModel& noise, std::mt19937* draw) {
  std::normal_distribution<double> normal;
  const double h = 0.01, decay = std::exp(-h / noise.disturbance.time);
  const double shock = noise.disturbance.std * std::sqrt(1.0 - decay * decay);
  const auto drag = [](double v) { return (10.0 * v + 300.0 * v * std::abs(v)) / 890.0; };
  double t = data.samples().front().time - 100.0, u = 0.0, v = 0.0, w = 0.0;
  Eigen::VectorXd residual(data.bins().size());
  for (int i = 0; i < residual.size(); ++i) {
    for (; t < data.samples()[i].time; t += h) {
      const double phase = std::fmod(t - data.samples().front().time + 4.0 * kHold, 2.0 * kHold);
      const double push = (phase < kHold ? 200.0 : 0.0) / 890.0;
      u += h * (push - drag(u));
      v += h * (push + w - drag(v));
      w = decay * w + shock * normal(*draw);
    }
    residual[i] = v - u + noise.velocity.white_std * normal(*draw);
  }
  return residual;
}

// A test of something slow while the vehicle lies still must not take its drifting about for it.
TEST(TrainingData, ScoresOfAVehicleAtRestAreAsLargeAsTheyShouldBe) {
  NoiseModel noise;
  noise.velocity.white_std = 0.004;
  noise.disturbance = {.std = 0.003, .time = 2.0};
  const auto mean_square = [&noise](const TrainingData& data) {
    NoiseModel of_data = noise;
    of_data.damping_rate = data.DampingRate(kVehicle);
    const Whitener whitener(of_data, data.samples());
    Eigen::VectorXd slow = Eigen::VectorXd::Zero(data.bins().size());
    for (int i = 0; i < slow.size(); ++i) {
      const double t = data.samples()[i].time - data.samples().front().time - 3.4 * kHold;
      if (t > 0.0 && t < 0.6 * kHold) {
        slow[i] = std::sin(std::numbers::pi * t / (0.6 * kHold));
      }
    }
    whitener.Apply({slow.data(), static_cast<size_t>(slow.size())},
                   {slow.data(), static_cast<size_t>(slow.size())});
    std::mt19937 draw(3);
    constexpr int kNumDraws = 400;
    double sum = 0.0;
    for (int k = 0; k < kNumDraws; ++k) {
      Eigen::VectorXd e = Disturbed(data, noise, &draw);
      whitener.Apply({e.data(), static_cast<size_t>(e.size())},
                     {e.data(), static_cast<size_t>(e.size())});
      sum += std::pow(slow.dot(e), 2) / slow.squaredNorm();
    }
    return sum / kNumDraws;
  };
  const TrainingData by_speed = DataOf(kVehicle), evenly = DataOf({});
  EXPECT_NEAR(mean_square(by_speed), 1.0, 0.28);  // 4 standard deviations of the mean
  EXPECT_GT(mean_square(evenly), 1.8);            // what this is for
}

}  // namespace
}  // namespace fathom
