// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The map that is suggested for a table of uvms-simlab, and the log that it makes.

#include "fathom/import/convert/import_log.h"
#include "fathom/import/map/import_map.h"
#include "fathom/import/open_recording.h"
#include "fathom/import/suggest/suggest_map.h"

#include <optional>
#include <string>

#include "scratch_file.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// A part of the header that the program writes, in its order.
const std::string kHeader =
    "timestamp,ros_time,base_x_force,base_y_force,base_z_force,base_x_torque,base_y_torque,"
    "base_z_torque,base_x,base_dx,dvl_speed_x,position_estimate.x,position_estimate.y,"
    "position_estimate.z,roll_estimate,pitch_estimate,yaw_estimate,orientation_estimate.w,"
    "velocity_estimate.x,velocity_estimate.y,velocity_estimate.z,angular_velocity_estimate.x,"
    "angular_velocity_estimate.y,angular_velocity_estimate.z,P_x_x,payload.mass\n";

// Row k: each column its number from 1, in tenths, plus k. The rows are 0.05 s apart.
std::string SimlabRows(int count) {
  std::string rows;
  for (int k = 0; k < count; ++k) {
    rows += fmt::format("{:.2f},{:.2f}", 0.05 * k, 1757795267.0 + 0.05 * k);
    for (int column = 3; column <= 26; ++column) rows += fmt::format(",{}", 0.1 * column + k);
    rows += "\n";
  }
  return rows;
}

TEST(SimlabMap, TakesTheWrenchAndTheEstimatedState) {
  const auto path = ScratchFile("robot_real_.csv", kHeader + SimlabRows(20));
  const auto recording = OpenRecording(path);
  const SuggestedMap map = SuggestMap(*recording, std::nullopt);
  EXPECT_TRUE(map.is_ready);
  const Log log = ImportLog(path, *recording, ParseImportMap("map", map.text), std::nullopt).log;
  EXPECT_NEAR(log.command->time[1] - log.command->time[0], 0.05, 1e-9);
  EXPECT_DOUBLE_EQ(log.command->Find("tau_surge")->at(1), 1.3);
  EXPECT_DOUBLE_EQ(log.command->Find("tau_yaw")->at(1), 1.8);
  EXPECT_DOUBLE_EQ(log.velocity->Find("u")->at(1), 2.9);
  EXPECT_DOUBLE_EQ(log.velocity->Find("r")->at(1), 3.4);
  EXPECT_DOUBLE_EQ(log.pose->Find("z")->at(1), 2.4);
}

TEST(SimlabMap, LeavesOtherTablesToTheirNames) {
  const auto recording =
      OpenRecording(ScratchFile("a.csv", "timestamp,base_x_force,u\n0,1,2\n1,1,2\n2,1,2\n"));
  const SuggestedMap map = SuggestMap(*recording, std::nullopt);
  EXPECT_FALSE(map.is_ready);
  EXPECT_THAT(map.text, HasSubstr("By the names"));
  EXPECT_THAT(map.text, Not(HasSubstr("simlab")));
}

}  // namespace
}  // namespace fathom
