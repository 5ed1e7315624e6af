// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Where Ceres gives up, it logs that it does. A user is told so once, in words of this program.

#include <cmath>
#include <filesystem>
#include <ostream>
#include <string>

#include "filmed_minute.h"
#include "run_tool.h"
#include "saved_files.h"
#include "small_log.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Path = std::filesystem::path;

// A log whose speed jumps between -speed and speed, as no vehicle moves.
struct Hopeless {
  std::string tool, dof_flag;
  double force = 0.0;  // amplitude of a sine [N]
  std::string speed;   // [m/s]
  std::string reason;  // as the program says it
};

void PrintTo(const Hopeless& hopeless, std::ostream* out) { *out << hopeless.tool; }

class QuietSolver : public ::testing::TestWithParam<Hopeless> {};

TEST_P(QuietSolver, KeepsItsLogToItself) {
  const Hopeless& hopeless = GetParam();
  const Path log = WriteSmallLog(EmptyTestFolder() / "log");
  std::string command = "t,tau_surge\n", velocity = "t,u\n";
  for (int row = 0; row < 600; ++row) {
    const std::string t = std::to_string(row / 10) + "." + std::to_string(row % 10);
    command += t + "," + std::to_string(hopeless.force * std::sin(0.05 * row)) + "\n";
    velocity += t + (row % 80 < 40 ? "," : ",-") + hopeless.speed + "\n";
  }
  WriteTestFile(log / "command.csv", command);
  WriteTestFile(log / "velocity.csv", velocity);
  const ToolRun run =
      RunToolBinary(hopeless.tool, {Flag("log", log), hopeless.dof_flag + "=surge"});
  EXPECT_EQ(run.exit_code, 2) << run.err;
  EXPECT_THAT(run.out + run.err, HasSubstr(hopeless.reason));
  for (const char* line : {".cc:", "Error in evaluating"}) {  // "trust_region_minimizer.cc:71]"
    EXPECT_THAT(run.err, Not(HasSubstr(line)));
  }
}

INSTANTIATE_TEST_SUITE_P(
    OfEachTool,
    QuietSolver,
    ::testing::Values(Hopeless{"fathom_identify", "--dof", 10.0, "1e6", "search did not converge"},
                      Hopeless{
                          "fathom_compare", "--dofs", 0.0, "1e6", "the search did not converge"},
                      Hopeless{"fathom_diagnose", "--dof", 10.0, "1e3", "no diagnosis: "}),
    [](const auto& info) { return info.param.tool; });

// No motion under 1e9 N can be simulated.
TEST(QuietSolver, KeepsItsLogToItselfInRefine) {
  const Path folder = EmptyTestFolder();
  const Path log = SynthesizeMinute(folder / "log", "wall.yaml", 40.0, 1);
  std::string command = "t,tau_surge\n";
  for (int t = 0; t <= 60; t += 3) {
    command += std::to_string(t) + (t % 2 == 0 ? ",-1e9\n" : ",1e9\n");
  }
  WriteTestFile(log / "command.csv", command);
  const Path page = folder / "page.html";
  const ToolRun run =
      RunToolBinary("fathom_refine", {Flag("log", log), "--dof=surge", Flag("report", page)});
  EXPECT_EQ(run.exit_code, 2) << run.err;
  EXPECT_THAT(run.err, HasSubstr("fathom_refine: no usable model: "));
  EXPECT_THAT(run.err, Not(HasSubstr(".cc:")));
  EXPECT_THAT(HeaderOf(TextOf(page)), HasSubstr("usable"));
}

}  // namespace
}  // namespace fathom
