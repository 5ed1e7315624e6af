// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// What is written for a user to fill in can be read, as it is and with every comment in use.

#include "fathom/starter/starter_texts.h"

#include "fathom/import/map/import_map.h"
#include "fathom/log/log_yaml.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <sstream>

#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// "#key: value", "#- item" and "#  further" are YAML; "# Words" stay comments.
std::string WithEveryKey(const std::string& text) {
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line);) {
    const bool is_key = line.size() > 2 && line[0] == '#' && (line[1] != ' ' || line[2] == ' ');
    result += (is_key ? line.substr(1) : line) + "\n";
  }
  return result;
}

const KnownOfLog kTank = {.name = "tank: \"07\"", .dofs = {Dof::kSurge, Dof::kYaw}};

TEST(StarterTexts, ALogYamlReadsAsItIs) {
  const Log log = ParseLogYaml("log.yaml", StarterLogYaml(kTank));
  EXPECT_EQ(log.name, "tank: \"07\"");
  EXPECT_THAT(log.dofs, ElementsAre(Dof::kSurge, Dof::kYaw));
  EXPECT_EQ(log.vehicle, "");
  EXPECT_FALSE(log.mass);
  EXPECT_TRUE(log.held_out.empty());
}

TEST(StarterTexts, EveryCommentedKeyOfALogYamlIsOneOfTheFormat) {
  const Log log = ParseLogYaml("log.yaml", WithEveryKey(StarterLogYaml(kTank)));
  EXPECT_EQ(log.vehicle, "vehicle.yaml");
  EXPECT_EQ(log.mass, 10.0);
  EXPECT_EQ(log.held_out.size(), 1U);
  EXPECT_EQ(log.command_unit, "A");
  EXPECT_EQ(log.dive, "2026-05-03 harbour");
  EXPECT_TRUE(log.start);
  EXPECT_EQ(log.notes, "still water, tether slack");
  EXPECT_EQ(log.video, "camera.mp4");
}

TEST(StarterTexts, WhatIsKnownOfALogIsNoComment) {
  KnownOfLog known = kTank;
  known.vehicle = "rov.yaml";
  known.video = "dive.mkv";
  known.span = TimeInterval{.from = 1433350600.0, .to = 1433350700.0};
  const std::string text = StarterLogYaml(known);
  const Log log = ParseLogYaml("log.yaml", text);
  EXPECT_EQ(log.vehicle, "rov.yaml");
  EXPECT_EQ(log.video, "dive.mkv");
  EXPECT_THAT(text, HasSubstr("\n#held_out: [1433350675.0, 1433350700.1]\n"));
}

TEST(StarterTexts, AVehicleFileReadsAsItIs) {
  const Vehicle vehicle = ParseVehicleFile("vehicle.yaml", StarterVehicleYaml("rov", 4));
  EXPECT_EQ(vehicle.name, "rov");
  EXPECT_FALSE(vehicle.mass);
  EXPECT_FALSE(vehicle.size);
  EXPECT_TRUE(vehicle.thrusters.empty());
}

TEST(StarterTexts, EveryCommentedKeyOfAVehicleFileIsOneOfTheFormat) {
  const Vehicle vehicle =
      ParseVehicleFile("vehicle.yaml", WithEveryKey(StarterVehicleYaml("rov", 4)));
  EXPECT_EQ(vehicle.mass, 10.0);
  EXPECT_TRUE(vehicle.size);
  ASSERT_EQ(vehicle.thrusters.size(), 4U);
  EXPECT_EQ(vehicle.thrusters[3].thrust_table, "my_thruster");
  EXPECT_EQ(vehicle.thrust_tables.size(), 1U);
}

TEST(StarterTexts, AMapReadsAsItIsAndWithEveryKey) {
  const std::string text =
      StarterMapYaml("dive", TimeInterval{.from = 10.0, .to = 110.0}, "velocity: {u: Speed}\n");
  EXPECT_EQ(ParseImportMap("map.yaml", text).name, "dive");
  const ImportMap map = ParseImportMap("map.yaml", WithEveryKey(text));
  EXPECT_EQ(map.mass, 10.0);
  ASSERT_EQ(map.held_out.size(), 1U);
  EXPECT_EQ(map.held_out[0].from, 85.0);
  EXPECT_EQ(map.held_out[0].to, 110.1);
}

}  // namespace
}  // namespace fathom
