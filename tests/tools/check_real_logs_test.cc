// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// What fathom_check says of logs that others recorded.

#include <sstream>

#include "checked_dive.h"
#include "real_data.h"
#include "saved_files.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using Json = nlohmann::json;
namespace fs = std::filesystem;
using Path = fs::path;

using CheckedRealLogs = OnRealData;

TEST_F(CheckedRealLogs, AreKnownAsWellAsFathomIdentifyKnowsThem) {
  const Path folder = EmptyTestFolder();
  const std::string log = Flag("log", Path(folder_) / "kingfisher_runs/run_20");
  const Path json = folder / "check.json", model = folder / "model.json";
  RunToolBinary("fathom_check", {log, "--dof=surge", Flag("json", json)});
  RunToolBinary("fathom_identify", {log, "--dof=surge", Flag("model", model)});
  const Json identified = JsonOf(model);
  const Json checked = JsonOf(json)["dofs"][0]["parameters"];
  ASSERT_EQ(checked.size(), 4u);
  for (const Json& parameter : checked) {
    const Json& same = identified["parameters"][parameter["name"].get<std::string>()];
    EXPECT_EQ(parameter["value"], same["value"]) << parameter;
    EXPECT_EQ(parameter["std"], same["std"]) << parameter;
  }
}

// A camera whose stamps are wrong is told once, and no axis for it.
TEST_F(CheckedRealLogs, TellACameraThatIsLate) {
  const Path folder = EmptyTestFolder();
  const Path log = folder / "log";
  fs::copy(Path(folder_) / "camera_by_others/heave_a", log);
  std::string shifted;
  std::istringstream rows(TextOf(log / "detections.csv"));
  for (std::string row; std::getline(rows, row);) {
    const auto comma = row.find(',');
    if (shifted.empty()) {
      shifted = row + "\n";
    } else {
      shifted +=
          fmt::format("{:.6f}{}\n", std::stod(row.substr(0, comma)) + 2.3, row.substr(comma));
    }
  }
  fs::permissions(log / "detections.csv", fs::perms::owner_write, fs::perm_options::add);
  WriteTestFile(log / "detections.csv", shifted);
  const Said said = Check(log, folder);
  ASSERT_EQ(said.findings.size(), 1u) << said.text;
  EXPECT_EQ(said.findings[0]["code"], "camera_delay");
  EXPECT_THAT(said.findings[0]["sentence"].get<std::string>(), HasSubstr("2.30 s after"));
  const Path page = folder / "check.html";
  RunToolBinary("fathom_check", {Flag("log", log), Flag("report", page)});
  EXPECT_THAT(TextOf(page),
              AllOf(HasSubstr("<b>correlation with w of velocity.csv</b>"),
                    HasSubstr("the most, at 2.30 s")));
}

// Logs that others recorded and that are sound: none gets a red finding.
TEST_F(CheckedRealLogs, GetNoRedFinding) {
  const Path folder = EmptyTestFolder();
  std::vector<std::string> logs = {"lbv_surge",
                                   "lbv_surge_short",
                                   "pool_rov_surge",
                                   "emps_pulses_pose",
                                   "emps_pulses_velocity",
                                   "dc_motor_stairs",
                                   "camera_by_others/heave_a",
                                   "camera_by_others/heave_b",
                                   "camera_by_others/surge_sine",
                                   "kingfisher_runs/run_01",
                                   "kingfisher_runs/run_02",
                                   "kingfisher_runs/run_12",
                                   "kingfisher_runs/run_13",
                                   "kingfisher_runs/run_16",
                                   "kingfisher_runs/run_20",
                                   "kingfisher_runs/run_28",
                                   "kingfisher_runs/run_30"};
  for (const char* run : {"neg_0.04_1", "neg_0.045_2", "pos_0.06_3", "pos_0.065_1"}) {
    logs.push_back(std::string("hsm150_runs/") + run);
  }
  for (const std::string& log : logs) {
    SCOPED_TRACE(log);
    const Said said = Check(folder_ / log, folder);
    EXPECT_EQ(said.exit_code, 0) << said.text;
  }
}

}  // namespace
}  // namespace fathom
