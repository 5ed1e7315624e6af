// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Four hours at 100 Hz.

#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <random>
#include <string>

#include "run_tool.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::StartsWith;

constexpr int kManyRows = 1'500'000;
constexpr double kStep = 0.01;         // [s]
constexpr double kMostMemory = 500e6;  // [bytes]

// Six tones of 5 N, each held for 0.1 s [N].
double LongForceAt(int row) {
  constexpr std::array<double, 6> kFrequencies = {0.15, 0.25, 0.42, 0.71, 1.2, 2.0};  // [rad/s]
  const double time = kStep * (row - row % 10);
  double force = 0.0;
  for (std::size_t k = 0; k < kFrequencies.size(); ++k) {
    force += 5.0 * std::sin(kFrequencies[k] * time + 1.7 * static_cast<double>(k * k));
  }
  return force;
}

// The vehicle of small_log.h by the midpoint rule, its speed with noise of 5 mm/s.
std::string LongCsv() {
  const auto acceleration = [](double speed, double force) {
    return (force - 30.0 * speed * std::abs(speed) - 5.0 * speed - 1.0) / 40.0;
  };
  std::mt19937 generator(1);
  std::normal_distribution<double> noise(0.0, 0.005);
  std::string csv = "t,tau,v\n";
  double speed = 0.0;
  for (int row = 0; row < kManyRows; ++row) {
    const double force = LongForceAt(row);
    csv += fmt::format("{:.2f},{:.4f},{:.5f}\n", kStep * row, force, speed + noise(generator));
    const double half_way = speed + 0.5 * kStep * acceleration(speed, force);
    speed += kStep * acceleration(half_way, force);
  }
  return csv;
}

TEST(LongLog, IsDiagnosedInLittleMemory) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "The address sanitizer takes memory of its own.";
#endif
  const std::filesystem::path folder = EmptyTestFolder();
  const std::filesystem::path log = WriteTestFile(folder / "log.csv", LongCsv());
  const ToolRun run = RunToolBinary("fathom_diagnose", {Flag("log", log), "--dof=surge"});
  std::filesystem::remove(log);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, StartsWith("surge: consistent\n"));
  EXPECT_GT(run.peak_memory, 10e6);  // it was measured
  EXPECT_LT(run.peak_memory, kMostMemory);
}

}  // namespace
}  // namespace fathom
