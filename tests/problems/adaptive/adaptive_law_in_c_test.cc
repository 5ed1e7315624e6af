// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// data/examples/adaptive_law.h, compiled as C99, against the law in C++.

#include "fathom/adaptive/adaptive_follower.h"
#include "fathom/process/run_child.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "experiments.h"
#include "test_folder.h"
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

const AdaptiveGains kGainsInC = {-0.0997, {1.09e-5, 19.6, 0.663, 0.0149}};

// Lines t,tau,v with a silence of 40 s in the middle.
std::vector<std::vector<double>> SamplesWithASilence() {
  const Segment segment = RunOf(FlatFishSurge(), 5);
  std::vector<std::vector<double>> samples;
  for (size_t i = 0; i < segment.time.size(); ++i) {
    const double silence = i < segment.time.size() / 2 ? 0.0 : 40.0;
    samples.push_back({segment.time[i] + silence, segment.command.value[i], segment.velocity[i]});
  }
  return samples;
}

// What the program in C prints.
std::vector<std::vector<double>> EstimatesInC(const std::vector<std::vector<double>>& samples,
                                              const std::string& integrator) {
  const auto file = TestFolder() / "samples.csv";
  std::ofstream out(file);
  for (const auto& sample : samples) out << fmt::format("{}\n", fmt::join(sample, ","));
  out.close();
  ChildCommand shell = {.program = "sh",
                        .arguments = {"-c", "input=$1; shift; exec \"$@\" < \"$input\"", "sh"}};
  shell.arguments.insert(shell.arguments.end(), {file.string(), FATHOM_ADAPTIVE_LAW_IN_C});
  shell.arguments.push_back(fmt::format("{}", kGainsInC.a_m));
  for (const double lambda : kGainsInC.lambda) {
    shell.arguments.push_back(fmt::format("{}", lambda));
  }
  shell.arguments.push_back(integrator);
  const ChildResult result = RunChild(shell);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  std::vector<std::vector<double>> rows;
  std::istringstream lines(result.out);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(std::stod(cell));
  }
  return rows;
}

class AdaptiveLawInC : public ::testing::TestWithParam<AdaptiveIntegrator> {};

TEST_P(AdaptiveLawInC, IsTheLawInCpp) {
  const auto samples = SamplesWithASilence();
  const auto in_c = EstimatesInC(samples, std::string(Name(GetParam())));
  ASSERT_EQ(in_c.size(), samples.size());
  AdaptiveFollower follower({.gains = kGainsInC, .integrator = GetParam()});
  for (size_t i = 0; i < samples.size(); ++i) {
    const auto& sample = samples[i];
    const ParameterVector truth = ToVector(follower.Add(sample[0], sample[1], sample[2]).model);
    for (int k = 0; k < kNumParameters; ++k) {
      ASSERT_NEAR(in_c[i][1 + k], truth[k], 1e-12 * std::max(1.0, std::abs(truth[k])))
          << kParameterInfo[k].name << " behind sample " << i;
    }
  }
  EXPECT_NEAR(follower.state().lumped[0], 1.0 / in_c.back()[1], 1e-12) << "alpha left its bound";
}

INSTANTIATE_TEST_SUITE_P(Integrators,
                         AdaptiveLawInC,
                         ::testing::Values(AdaptiveIntegrator::kEuler,
                                           AdaptiveIntegrator::kRungeKutta),
                         [](const auto& info) { return std::string(Name(info.param)); });

}  // namespace
}  // namespace fathom
