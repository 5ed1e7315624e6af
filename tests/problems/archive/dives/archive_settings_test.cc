// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/dives/archive_settings.h"

#include <string>

#include "error_from.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;

TEST(ParseArchiveSettings, ReadsEveryKey) {
  const ArchiveSettings settings =
      ParseArchiveSettings("x/archive.yaml",
                           "dive_level: 2\nvehicle: rov.yaml\ndof: heave\n"
                           "leave_out: [calibration, '*/old/*']\n"
                           "imports: [{files: '*.BIN'}, {files: bags/*, map: maps/bag.yaml, "
                           "vehicle: boat.yaml}]\n");
  EXPECT_EQ(settings.dive_level, 2);
  EXPECT_EQ(settings.dive_pattern, "");
  EXPECT_EQ(settings.vehicle_name, "rov.yaml");
  EXPECT_EQ(settings.vehicle, "x/rov.yaml");
  EXPECT_EQ(settings.dof, Dof::kHeave);
  EXPECT_THAT(settings.leave_out, ElementsAre("calibration", "*/old/*"));
  ASSERT_EQ(settings.imports.size(), 2U);
  EXPECT_EQ(settings.imports[0].map, "");
  EXPECT_EQ(settings.imports[0].vehicle, "x/rov.yaml");
  EXPECT_EQ(settings.imports[1].map, "x/maps/bag.yaml");
  EXPECT_EQ(settings.imports[1].vehicle, "x/boat.yaml");
  EXPECT_EQ(ImportOf("2024/dive.BIN", settings), &settings.imports[0]);
  EXPECT_EQ(ImportOf("bags/a/b.bag", settings), &settings.imports[1]);
  EXPECT_EQ(ImportOf("dive.bin", settings), nullptr);
}

TEST(ParseArchiveSettings, NamesFileLineAndKey) {
  EXPECT_THAT(
      ErrorFrom([&] { ParseArchiveSettings("archive.yaml", "dof: heave\ndive_level: 101\n"); }),
      testing::StartsWith("archive.yaml:2: key 'dive_level' is 101"));
}

// Found by its fuzz target: the standard library overflows on such a count.
TEST(ParseArchiveSettings, RefusesAPatternWithAHugeCount) {
  EXPECT_THAT(ErrorFrom([&] {
                ParseArchiveSettings("archive.yaml", "dive_pattern: m[0-9]{9999999999999999999}\n");
              }),
              testing::HasSubstr("expected counts below 1000"));
}

TEST(DiveOfPath, IsTheFolderOfTheLog) {
  EXPECT_EQ(DiveOfPath("a/b/run", {}), "a/b");
  EXPECT_EQ(DiveOfPath("a/run.csv", {}), "a");
  EXPECT_EQ(DiveOfPath("run", {}), "run");
  EXPECT_EQ(DiveOfPath(".", {}), ".");
  EXPECT_EQ(DiveOfPath("a\xff/run", {}), "a\\xff");
}

TEST(DiveOfPath, IsTheFolderAtTheLevel) {
  EXPECT_EQ(DiveOfPath("a/b/run", {.dive_level = 1}), "a");
  EXPECT_EQ(DiveOfPath("a/b/run", {.dive_level = 2}), "b");
  // The log itself is no folder of its path.
  EXPECT_EQ(DiveOfPath("a/b/run", {.dive_level = 3}), "a/b/run");
}

TEST(DiveOfPath, IsTheFirstMatchOfThePattern) {
  const ArchiveSettings settings = {.dive_level = {}, .dive_pattern = "[0-9]{4}-[0-9]{2}"};
  EXPECT_EQ(DiveOfPath("cruise 2024-05/2024-06/run", settings), "2024-05");
  EXPECT_EQ(DiveOfPath("test/run", settings), "test/run");
}

TEST(DiveOfPath, TakesAPathOfAnyLength) {
  // std::regex recurses with each character of a repetition.
  const std::string longest(4000, 'a');
  EXPECT_EQ(DiveOfPath(longest, {.dive_level = {}, .dive_pattern = ".*"}), longest);
}

TEST(IsLeftOut, MatchesAsAShellDoes) {
  const ArchiveSettings settings = {.leave_out = {"calibration", "*/old/*", "dive [12]"}};
  EXPECT_TRUE(IsLeftOut("calibration", settings));
  EXPECT_FALSE(IsLeftOut("a/calibration", settings));
  EXPECT_TRUE(IsLeftOut("a/b/old/c", settings));
  EXPECT_TRUE(IsLeftOut("dive 2", settings));
  EXPECT_FALSE(IsLeftOut("dive 3", settings));
  EXPECT_FALSE(IsLeftOut("x", {}));
}

}  // namespace
}  // namespace fathom
