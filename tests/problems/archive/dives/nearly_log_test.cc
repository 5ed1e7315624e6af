// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/dives/nearly_log.h"

#include <filesystem>
#include <fstream>
#include <string>

#include "test_folder.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

TEST(NearlyLog, IsAFolderOfStreamsWithoutALogYaml) {
  EXPECT_EQ(WhyFolderIsNearlyLog({"velocity.csv", "command.csv", "notes.txt"}),
            "holds command.csv, velocity.csv and no log.yaml");
  EXPECT_EQ(WhyFolderIsNearlyLog({"log.yml"}), "holds log.yml, expected log.yaml");
  EXPECT_EQ(WhyFolderIsNearlyLog({"Log.YAML", "pose.csv"}), "holds Log.YAML, expected log.yaml");
  EXPECT_FALSE(WhyFolderIsNearlyLog({"velocity.csv", "notes.txt"}));
  EXPECT_FALSE(WhyFolderIsNearlyLog({}));
}

TEST(NearlyLog, IsATableThatIsCloseToOne) {
  const std::filesystem::path folder = EmptyTestFolder();
  const auto why = [&](const std::string& name, const std::string& text) {
    std::ofstream(folder / name) << text;
    return WhyFileIsNearlyLog(folder / name).value_or("");
  };
  const std::string names = "its first line does not name t, tau and v";
  EXPECT_EQ(why("a.csv", "t,tau,w\n"), names);
  EXPECT_EQ(why("a.csv", "t_ms,tau,v [m/s]\n"), names);
  EXPECT_EQ(why("a.CSV", "t,tau,v\n"), "ends in .CSV, expected .csv");
  EXPECT_EQ(why("a.csv", "t;tau;v\n0,1;2,5;0\n"),
            "its columns are separated by semicolons, expected commas and decimal points");
  EXPECT_THAT(why("a.csv", "t [s]\ttau [N]\tv [m/s]\r\n"), HasSubstr("separated by tabs"));
  EXPECT_EQ(why("a.csv", "time;depth\n"), "");
  EXPECT_EQ(why("a.csv", "t,tau,v\n"), "");
  EXPECT_EQ(why("a.csv", "time,depth\n"), "");
  EXPECT_EQ(why("command.csv", "t,tau_surge,v\n"), "");
  EXPECT_EQ(why("a.txt", "t,tau,w\n"), "");
}

TEST(NearlyLogsSentence, NamesAFew) {
  EXPECT_EQ(NearlyLogsSentence({}), "");
  EXPECT_EQ(NearlyLogsSentence({{"a/x.csv", "why"}}), "1 place is nearly a log: a/x.csv (why).");
  EXPECT_EQ(NearlyLogsSentence({{"a", "1"}, {"b", "2"}, {"c", "3"}, {"d", "4"}}),
            "4 places are nearly logs: a (1), b (2), c (3) and 1 more.");
}

}  // namespace
}  // namespace fathom
