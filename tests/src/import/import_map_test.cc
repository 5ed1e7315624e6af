// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/map/import_map.h"

#include <string>

#include "scratch_file.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;

TEST(ImportMap, ReadsEveryKey) {
  const ImportMap map = ParseImportMap("map.yaml", R"(
name: dive_7
dof: [surge, yaw]
vehicle: rov.yaml
mass: 11.5
dive: harbour
notes: tether slack
table: {separator: tab, decimal: ",", header_line: 3, time: clock, time_unit: ms}
command:
  channel: RCOU
  unit: us
  delay: 0.1
  where: {slave: 16, cmd: 0}
  thruster_1: C1
  thruster_2: {field: C2, scale: -1, offset: 3000}
  voltage: {channel: BAT, field: Volt}
velocity:
  channel: DVL
  frame: ENU
  rate: 8
  u: vx
  r: {channel: IMU, field: GyrZ, unit: deg/s}
pose: {channel: XKF1, frame: NED, x: PN, y: PE, z: PD, roll: Roll, pitch: Pitch, yaw: Yaw}
camera: {video: films/dive.mp4, start: 2026-05-03T14:30:05.25Z, tags: wall.yaml}
)");
  EXPECT_EQ(map.name, "dive_7");
  EXPECT_EQ(map.dofs.size(), 2U);
  EXPECT_EQ(*map.mass, 11.5);
  EXPECT_EQ(*map.table.separator, '\t');
  EXPECT_EQ(*map.table.decimal, ',');
  EXPECT_EQ(*map.table.header_line, 3);
  EXPECT_EQ(map.table.time_unit, "ms");
  EXPECT_EQ(map.command->delay, 0.1);
  ASSERT_EQ(map.command->where.size(), 2U);
  EXPECT_EQ(map.command->where[0].field, "slave");
  EXPECT_EQ(map.command->where[0].value, 16.0);
  EXPECT_EQ(map.command->Find("thruster_2")->offset, 3000.0);
  EXPECT_EQ(map.voltage->channel, "BAT");
  EXPECT_EQ(*map.velocity->frame, Frame::kEnu);
  EXPECT_EQ(*map.velocity->rate, 8.0);
  EXPECT_EQ(map.velocity->Find("r")->unit, "deg/s");
  EXPECT_EQ(map.velocity->Find("q"), nullptr);
  EXPECT_EQ(map.pose->columns.size(), 6U);
  EXPECT_TRUE(map.camera->is_utc);
  EXPECT_EQ(map.camera->start, 1777818605.25);  // date -u -d 2026-05-03T14:30:05Z +%s
  EXPECT_THAT(map.camera->Files(),
              ElementsAre(Pair("dive.mp4", "films/dive.mp4"),
                          Pair("camera.yaml", "camera.yaml"),
                          Pair("tags.yaml", "wall.yaml"),
                          Pair("mount.yaml", "mount.yaml")));
}

TEST(ImportMap, HasANameThatHoldsSomethingOrNone) {
  EXPECT_THAT(
      ErrorFrom([] { ParseImportMap("m.yaml", "dof: surge\nname: \"\"\nvelocity: {u: 2}"); }),
      HasSubstr("m.yaml:2: key 'name' is empty, expected a name."));
}

TEST(ImportMap, SaysWhatIsWrong) {
  const auto error = [](const std::string& text) {
    return ErrorFrom([&] { ParseImportMap("map.yaml", text); });
  };
  EXPECT_THAT(error("dof: surge\n"), HasSubstr("names no stream"));
  EXPECT_THAT(error("velocity: {u: a}\nspeed: 3\n"), HasSubstr("'speed'"));
  EXPECT_THAT(error("velocity: {speed: a}\n"), HasSubstr("names no column"));
  EXPECT_THAT(error("velocity: {u: a, v2: b}\n"), HasSubstr("v2"));
  EXPECT_THAT(error("velocity: {u: a, frame: up}\n"), HasSubstr("FRD, FLU, NED, ENU or NWU"));
  EXPECT_THAT(error("velocity: {u: a, rate: 0}\n"), HasSubstr("above 0 Hz"));
  EXPECT_THAT(error("velocity: {u: {field: a, scale: 0}}\n"), HasSubstr("scale"));
  EXPECT_THAT(error("dof: up\nvelocity: {u: a}\n"), HasSubstr("'up'"));
  EXPECT_THAT(error("command: {frame: NED, tau_surge: a}\n"), HasSubstr("FRD or FLU"));
  EXPECT_THAT(error("command: {tau_surge: a, thruster_1: b}\n"), HasSubstr("thruster_1"));
  EXPECT_THAT(error("command: {thruster_1: a, thruster_3: b}\n"), HasSubstr("thruster_3"));
  EXPECT_THAT(error("pose: {x: a, yaw: b}\n"), HasSubstr("one of x and y"));
  EXPECT_THAT(error("pose: {x: a, y: b}\n"), HasSubstr("an attitude"));
  EXPECT_THAT(error("pose: {x: a, y: b, qx: c, qw: d}\n"), HasSubstr("qx qy qz qw"));
  EXPECT_THAT(error("pose: {x: a, y: b, yaw: c, frame: FLU}\n"), HasSubstr("NED, ENU or NWU"));
  EXPECT_THAT(error("velocity: {u: a}\ncamera: {start: 3}\n"), HasSubstr("'camera.video'"));
  EXPECT_THAT(error("velocity: {u: a}\ncamera: {video: films/}\n"), HasSubstr("names a folder"));
  for (const char* path : {"/etc/shadow", "../dive.mp4", "a/../../dive.mp4"}) {
    const std::string camera = fmt::format("velocity: {{u: a}}\ncamera: {{video: {}}}\n", path);
    EXPECT_THAT(error(camera), HasSubstr("stays in it"));
  }
  EXPECT_THAT(error("velocity: {u: a}\ncamera: {video: a.mp4, mount: /etc/hostname}\n"),
              AllOf(HasSubstr("'camera.mount' is '/etc/hostname'"), HasSubstr("stays in it")));
  EXPECT_THAT(error("velocity: {u: a}\ncamera: {video: a.mp4, start: noon}\n"),
              HasSubstr("'camera.start'"));
  EXPECT_THAT(error("table: {separator: x}\nvelocity: {u: a}\n"), HasSubstr("separator"));
}

}  // namespace
}  // namespace fathom
