// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// fathom_diagnose on logs of real vehicles, whose causes nobody knows for certain: what it must not
// claim. docs/diagnosis_lbv_surge.md, docs/diagnosis_lbv_yaw.md, docs/diagnosis_pool_rov_surge.md.

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "real_data.h"
#include "run_tool.h"
#include "saved_files.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Path = std::filesystem::path;

class RealDiagnoses : public OnRealData {
 protected:
  // The verdict on a log.
  nlohmann::json Diagnosed(const std::string& log,
                           const std::string& dof,
                           const std::vector<std::string>& more = {}) {
    const Path verdict = EmptyTestFolder() / "verdict.json";
    std::vector<std::string> flags = {
        Flag("log", folder_ / log), "--dof=" + dof, Flag("verdict", verdict)};
    flags.insert(flags.end(), more.begin(), more.end());
    run_ = RunToolBinary("fathom_diagnose", flags);
    EXPECT_EQ(run_.exit_code, 0) << run_.err;
    return JsonOf(verdict);
  }

  ToolRun run_;
};

// Effects that are named without an alternative.
std::set<std::string> CertainCauses(const nlohmann::json& verdict) {
  std::set<std::string> names;
  for (const auto& cause : verdict["causes"]) {
    if (cause["alternatives"].empty()) names.insert(cause["effect"]);
  }
  return names;
}

// A tether gains in the poses by hand and fails on held-out speeds; a delay goes with the inertia.
TEST_F(RealDiagnoses, LbvSurgeNamesNoCauseForCertain) {
  EXPECT_THAT(CertainCauses(Diagnosed("lbv_surge", "surge")), IsEmpty());
}

// The spring that fits best makes unseen data worse.
TEST_F(RealDiagnoses, LbvSurgeByTheAuthorsVelocityNamesNoSpring) {
  const auto verdict = Diagnosed("lbv_surge", "surge", {"--velocity=author_velocity.csv"});
  EXPECT_THAT(verdict["causes"], IsEmpty());
  EXPECT_THAT(
      run_.out,
      HasSubstr(": position_stiffness. It improves the fit, but the error on held-out data grows"));
}

// One tone: its phase is any delay, lag or force at the same frequency.
TEST_F(RealDiagnoses, LbvYawIsNotExplainedByItsOneTone) {
  const auto verdict = Diagnosed("lbv_yaw", "yaw");
  EXPECT_THAT(verdict["verdict"].get<std::string>(), AnyOf("ambiguous", "unexplained"));
  EXPECT_EQ(CertainCauses(verdict).count("periodic_force"), 0u);
  EXPECT_THAT(run_.out, HasSubstr("almost a single sine"));
  // Something that brings the phase right must gain a lot, on unseen data as well.
  EXPECT_LT(verdict["extended"]["heldout_nmae"].get<double>(),
            0.5 * verdict["baseline"]["heldout_nmae"].get<double>());
}

// Bursts of one size: saturation, dead zone, curve and gain are one, lag and ramp nearly so.
TEST_F(RealDiagnoses, PoolRovSurgeMissesSomethingAndNamesNoCauseForCertain) {
  const auto verdict = Diagnosed("pool_rov_surge", "surge");
  EXPECT_THAT(verdict["verdict"].get<std::string>(), AnyOf("ambiguous", "unexplained"));
  EXPECT_THAT(CertainCauses(verdict), IsEmpty());
  // What is left out again leaves no trace.
  if (verdict["causes"].empty()) {
    EXPECT_EQ(verdict["extended"]["parameters"], verdict["baseline"]["parameters"]);
  }
  // By hand, from 575 to 800 s: 0.102.
  EXPECT_LT(verdict["extended"]["heldout_nmae"].get<double>(), 0.12);
}

}  // namespace
}  // namespace fathom
