// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/single_csv.h"

#include "fathom/base/files/output_file.h"
#include "fathom/base/input_error.h"
#include "fathom/log/read_log.h"

#include <string>
#include <utility>
#include <vector>

#include "error_from.h"
#include "test_folder.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::filesystem::path SingleCsv(const std::string& text) {
  const auto file = EmptyTestFolder() / "run.csv";
  WriteFile(file, text);
  return file;
}

TEST(ReadLog, ReadsASingleCsvOfTheGivenDof) {
  const auto file = SingleCsv("t,tau,v,n\n0,1,0.5,7\n0.1,2,0.6,7\n");
  const Log log = ReadLog(file, {.dof = Dof::kYaw, .velocity = {}});
  EXPECT_EQ(log.name, "run");
  EXPECT_THAT(log.dofs, ElementsAre(Dof::kYaw));
  EXPECT_THAT(log.command->time, ElementsAre(0, 0.1));
  EXPECT_THAT(*log.command->Find("tau_yaw"), ElementsAre(1, 2));
  EXPECT_THAT(*log.velocity->Find("r"), ElementsAre(0.5, 0.6));
  EXPECT_THAT(TextsOf(log.remarks), ElementsAre("run.csv: 1 further column is not read: n."));
}

TEST(ReadLog, ReadsASingleCsvOfAFreeDecayWhereNoCommandIsNeeded) {
  const auto file = SingleCsv("t,v\n0,0.5\n0.1,0.6\n");
  const Log log = ReadLog(file, {.dof = Dof::kYaw, .may_lack_command = true});
  EXPECT_FALSE(log.command.has_value());
  ASSERT_TRUE(log.velocity.has_value());
  EXPECT_EQ(log.velocity->columns, std::vector<std::string>{"r"});
  EXPECT_THROW(ReadLog(file, {.dof = Dof::kYaw}), InputError);
}

TEST(ReadLog, PutsTheSpeedOfASingleCsvRight) {
  const auto file = SingleCsv("t,tau,v\n0,1,0.5\n0.1,2,0.6\n");
  const Log log = ReadLog(file, {.dof = Dof::kYaw, .corrections = {{"v", -2.0}}});
  EXPECT_THAT(*log.velocity->Find("r"), ElementsAre(-1.0, -1.2));
  EXPECT_THAT(TextsOf(log.remarks), ElementsAre("run.csv: r times -2, as --correct says."));
  EXPECT_EQ(ErrorFrom([&] {
              ReadLog(file, {.dof = Dof::kYaw, .corrections = {{"r", -2.0}}});
            }),
            "--correct: corrects 'r', which is no speed of " + file.string() + ", expected v.");
}

TEST(ReadLog, NeedsTheDofOfASingleCsv) {
  const auto file = SingleCsv("t,tau,v\n0,1,0.5\n0.1,2,0.6\n");
  EXPECT_EQ(
      ErrorFrom([&] { ReadLog(file); }),
      file.string() +
          ": a single CSV (t,tau,v) does not say whose force and speed it holds, expected --dof "
          "with it: --dof=surge, sway, heave, roll, pitch or yaw.");
}

TEST(ReadLog, RefusesAnotherVelocityForASingleCsv) {
  const auto file = SingleCsv("t,tau,v\n0,1,0.5\n0.1,2,0.6\n");
  EXPECT_EQ(
      ErrorFrom([&] { ReadLog(file, {.dof = Dof::kSurge, .velocity = "v.csv"}); }),
      "--velocity=v.csv: " + file.string() +
          " is a single CSV with its own speed, expected a log folder. Leave out --velocity.");
}

TEST(ReadLog, NamesTheMissingColumnOfASingleCsv) {
  const auto file = SingleCsv("t,tau,u\n0,1,0.5\n0.1,2,0.6\n");
  EXPECT_EQ(ErrorFrom([&] { ReadLog(file, {.dof = Dof::kSurge, .velocity = {}}); }),
            file.string() +
                ":1: column 'v' is missing, found t, tau, u; expected t, tau, v. fathom_import "
                "makes a log of what other programs write: fathom_import --from=" +
                file.string() + " --suggest > map.yaml");
}

// What is wrong with it as a single CSV leads nowhere.
TEST(ReadLog, NamesOnlyTheImportForACsvOfAnotherShape) {
  for (const char* text :
       {"Pool test 7\r\nTime;Thrust\r\n0;1\r\n", "Time,Thrust,Speed\r\n0,1,2\r\n"}) {
    const auto file = SingleCsv(text);
    EXPECT_EQ(ErrorFrom([&] { ReadLog(file, {.dof = Dof::kSurge, .velocity = {}}); }),
              file.string() +
                  ": is no log, expected a log folder or a CSV with columns t, tau, v. "
                  "fathom_import makes a log of what other programs write: fathom_import --from=" +
                  file.string() + " --suggest > map.yaml");
  }
}

TEST(ReadLog, NamesTheMistakeInTheFirstLineOfASingleCsv) {
  for (const auto& [text, mistake] : {std::pair{"\xef\xbb\xbft,tau,v\n0,1,2\n", "byte order mark"},
                                      {"t,tau [N],v\n0,1,2\n", "with a unit"}}) {
    const auto file = SingleCsv(text);
    EXPECT_THAT(ErrorFrom([&] { ReadLog(file, {.dof = Dof::kSurge, .velocity = {}}); }),
                HasSubstr(mistake));
  }
}

}  // namespace
}  // namespace fathom
