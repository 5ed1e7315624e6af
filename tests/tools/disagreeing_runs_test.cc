// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// fathom_identify on runs of one vehicle, one of which was heavier.

#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "run_tool.h"
#include "saved_files.h"
#include "synthesized_log.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;
using Path = std::filesystem::path;

constexpr std::array<double, 4> kInertias = {40.0, 40.0, 41.0, 40.0};  // [kg]

// small_log.h's vehicle with another inertia [kg].
std::string YamlOfInertia(double inertia) {
  std::string text = SmallVehicleYaml();
  const std::string usual = "inertia: 40";
  return text.replace(text.find(usual), usual.size(), fmt::format("inertia: {}", inertia));
}

struct Estimate {
  double value = 0.0, std = 0.0;
};

// The first pair of "run_1   39.955 ± 0.034   29.80 ± 0.17 ...".
Estimate InertiaOfRun(const std::string& run, const std::string& table) {
  const std::size_t at = table.find("\n" + run + " ");
  if (at == std::string::npos) return {NAN, NAN};
  std::istringstream row(table.substr(at));
  std::string name, plus_minus;
  Estimate estimate;
  row >> name >> estimate.value >> plus_minus >> estimate.std;
  return estimate;
}

struct Scatter {
  double chi_squared = 0.0;  // about the weighted mean
  double mean_std = 0.0;     // of that, by what they scatter by
};

Scatter ScatterOf(const std::vector<Estimate>& estimates) {
  double weights = 0.0, sum = 0.0;
  for (const auto& [value, std] : estimates) {
    weights += 1.0 / (std * std);
    sum += value / (std * std);
  }
  Scatter scatter;
  for (const auto& [value, std] : estimates) {
    scatter.chi_squared += std::pow((value - sum / weights) / std, 2);
  }
  const double freedom = static_cast<double>(estimates.size()) - 1.0;
  scatter.mean_std = std::sqrt(scatter.chi_squared / freedom / weights);
  return scatter;
}

TEST(DisagreeingRuns, AreToldOneByOneWithTheOneThatStandsApart) {
  const Path folder = EmptyTestFolder();
  std::vector<std::string> arguments = {"--dof=surge"};
  for (std::size_t k = 0; k < kInertias.size(); ++k) {
    const std::string name = fmt::format("run_{}", k + 1);
    const int seed = static_cast<int>(k) + 1;
    const Path log = SmallLogWith(folder, name, "", seed, YamlOfInertia(kInertias[k]));
    WriteTestFile(log / "log.yaml", "name: " + name + "\ndof: surge\nheld_out: [70, 90]\n");
    arguments.push_back(Flag("log", log));
  }
  const ToolRun run = RunsWell("fathom_identify", arguments);

  ASSERT_THAT(run.out, HasSubstr("\nrun alone "));
  std::vector<Estimate> inertias;
  for (std::size_t k = 0; k < kInertias.size(); ++k) {
    inertias.push_back(InertiaOfRun(fmt::format("run_{}", k + 1), run.out));
    EXPECT_NEAR(inertias[k].value, kInertias[k], 4.0 * inertias[k].std);
  }
  // Two digits of each standard deviation are printed: 1.5 % of 0.034, twice that of its square.
  const double chi_squared = NumberBehind("chi-square / degrees of freedom", run.out);
  const Scatter scatter = ScatterOf(inertias);
  EXPECT_NEAR(chi_squared, scatter.chi_squared, 0.04 * chi_squared);
  EXPECT_THAT(run.out, HasSubstr(" / 3 "));
  EXPECT_THAT(run.out, HasSubstr("note: run_3 stands apart from the others in its inertia"));

  // The interval of all is as wide as the runs scatter, and says so.
  EXPECT_THAT(run.out, HasSubstr("widened: inertia by a factor of "));
  EXPECT_NEAR(InertiaOfRun("inertia", run.out).std, scatter.mean_std, 0.04 * scatter.mean_std);
}

}  // namespace
}  // namespace fathom
