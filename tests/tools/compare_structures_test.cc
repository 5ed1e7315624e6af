// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// fathom_compare --structures.

#include <cmath>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "expect_refusal.h"
#include "run_tool.h"
#include "saved_files.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// A log of the plane, 90 s at 10 Hz, of forces that step every 1.5 s. Integrated here by Euler in
// steps of 1 ms: a diagonal inertia with C(nu), whose forces are m_22 v r, -m_11 u r and
// (m_11 - m_22) u v.
std::filesystem::path PlanarLog() {
  const std::filesystem::path folder = EmptyTestFolder() / "plane";
  std::mt19937 random(5);
  std::uniform_real_distribution<double> level(-1.0, 1.0);
  std::normal_distribution<double> noise(0.0, 0.003);
  std::string command = "t,tau_surge,tau_sway,tau_yaw\n", velocity = "t,u,v,r\n";
  double x = 0.0, y = 0.0, n = 0.0, u = 0.0, v = 0.0, r = 0.0;
  for (int ms = 0; ms < 90000; ++ms) {
    if (ms % 1500 == 0) {
      x = 30.0 * level(random);
      y = 15.0 * level(random);
      n = 3.0 * level(random);
      command += fmt::format("{},{},{},{}\n", 1e-3 * ms, x, y, n);
    }
    if (ms % 100 == 0) {
      velocity += fmt::format(
          "{},{},{},{}\n", 1e-3 * ms, u + noise(random), v + noise(random), r + noise(random));
    }
    const double du = (x + 50.0 * v * r - 8.0 * u - 20.0 * u * std::abs(u)) / 40.0;
    const double dv = (y - 40.0 * u * r - 12.0 * v - 50.0 * v * std::abs(v)) / 50.0;
    const double dr = (n + (40.0 - 50.0) * u * v - 3.0 * r - 4.0 * r * std::abs(r)) / 5.0;
    u += 1e-3 * du;
    v += 1e-3 * dv;
    r += 1e-3 * dr;
  }
  WriteTestFile(folder / "log.yaml", "name: plane\ndof: [yaw, surge, sway]\nheld_out: [75, 90]\n");
  WriteTestFile(folder / "command.csv", command);
  WriteTestFile(folder / "velocity.csv", velocity);
  return folder;
}

TEST(CompareStructures, WritesARowForEachStructureBesideModelsOfOneDof) {
  const std::filesystem::path log = PlanarLog();
  const std::filesystem::path json_file = log / "rows.json", page = log / "page.html";
  const ToolRun run = RunsWell("fathom_compare",
                               {Flag("log", log),
                                "--structures=diagonal,coriolis",
                                "--families=least_squares",
                                Flag("json", json_file),
                                Flag("report", page)});
  EXPECT_THAT(run.out,
              AllOf(StartsWith("The least errors are those of coriolis, 12 numbers."),
                    HasSubstr("its runs are nearer than those of the best models of one DOF each "
                              "(least squares), by"),
                    HasSubstr("* coriolis"),
                    HasSubstr("held out")));
  const auto json = JsonOf(json_file);
  EXPECT_EQ(json["schema"], "fathom-structures-1");
  EXPECT_EQ(json["dofs"], nlohmann::json({"surge", "sway", "yaw"}));
  ASSERT_EQ(json["rows"].size(), 3u);
  EXPECT_EQ(json["rows"][0]["family"], "least_squares");
  EXPECT_EQ(json["rows"][1]["structure"], "diagonal");
  EXPECT_EQ(json["rows"][2]["structure"], "coriolis");
  EXPECT_EQ(json["rows"][2]["taken"], true);
  for (const char* dof : {"surge", "sway", "yaw"}) {
    for (const char* figure : {"nmae", "heldout_nmae", "unseen_nmae"}) {
      EXPECT_LT(json["rows"][2][figure][dof], json["rows"][0][figure][dof]) << figure << dof;
    }
  }
  EXPECT_THAT(HeaderOf(TextOf(page)), HasSubstr("The least errors are those of coriolis"));
}

TEST(CompareStructures, RefusesWhatItDoesNotKnow) {
  const std::string log = Flag("log", PlanarLog());
  for (const auto& [flags, message] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"--structures=square"},
            "--structures: is 'square', expected all, or of diagonal, coriolis, lift, symmetric, "
            "full, lopsided and auto."},
           {{"--structures=full,full"}, "--structures: names full twice, expected each once."},
           {{"--structures=auto,auto"}, "--structures: names auto twice, expected each once."},
           {{"--structures=,"}, "--structures: is '', expected all, or of diagonal"},
           {{"--structures=full", "--families=joint"}, "--families: "},
           {{"--structures=full", "--sources=camera"},
            "--sources: goes with families, expected none beside --structures."},
           {{"--window=5"},
            "--window: goes with --structures, expected none: families have no window."}}) {
    std::vector<std::string> arguments = {log};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    EXPECT_THAT(ExpectRefusal("fathom_compare", arguments), HasSubstr(message));
  }
}

}  // namespace
}  // namespace fathom
