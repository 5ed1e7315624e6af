// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/dives/walk_archive.h"

#include "fathom/base/input_error.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "error_from.h"
#include "test_folder.h"
#include <gmock/gmock.h>
#include <sys/stat.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;

using ::testing::ElementsAre;
using ::testing::Pair;

void Write(const fs::path& file, const std::string& text = "") {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

std::vector<std::string> PathsOf(const FoundArchive& found) {
  std::vector<std::string> paths;
  for (const FoundLog& log : found.logs) paths.push_back(log.path);
  return paths;
}

TEST(WalkArchive, FindsFoldersWithALogYamlAndCsvLogs) {
  const fs::path archive = EmptyTestFolder();
  Write(archive / "b" / "run" / "log.yaml");
  Write(archive / "b" / "run" / "command.csv");
  Write(archive / "a" / "x.csv", "\"t\", tau,v\r\n1,2,3\n");
  Write(archive / "a" / "v_first.csv", "v,extra,tau,t\n");
  Write(archive / "a" / "y.csv", "t,tau,w\n");
  Write(archive / "a" / "z.txt", "t,tau,v\n");
  Write(archive / "a" / "empty.csv");
  Write(archive / "README");
  const FoundArchive found = WalkArchive(archive, {});
  EXPECT_THAT(PathsOf(found), ElementsAre("a/v_first.csv", "a/x.csv", "b/run"));
  EXPECT_EQ(found.logs[2].place, archive / "b" / "run");
  EXPECT_THAT(found.other_files,
              ElementsAre(Pair(".csv", 2), Pair(".txt", 1), Pair("without an ending", 1)));
  EXPECT_TRUE(found.unreadable.empty());
}

TEST(WalkArchive, TellsWhatIsNearlyALog) {
  const fs::path archive = EmptyTestFolder();
  Write(archive / "a" / "y.csv", "t,tau,w\n");
  Write(archive / "b" / "command.csv", "t,tau_surge\n");
  Write(archive / "b" / "velocity.csv", "t,u\n");
  Write(archive / "c" / "log.yaml");
  Write(archive / "c" / "command.csv", "t,tau,w\n");
  Write(archive / "d" / "y.csv", "t,tau,w\n");
  const FoundArchive found = WalkArchive(archive, {.leave_out = {"d"}});
  std::vector<std::string> nearly;
  for (const NearlyLog& one : found.nearly_logs) nearly.push_back(one.path + ": " + one.why);
  EXPECT_THAT(nearly,
              ElementsAre("a/y.csv: its first line does not name t, tau and v",
                          "b: holds command.csv, velocity.csv and no log.yaml"));
}

TEST(WalkArchive, FindsTheArchiveItselfAndLogsInLogs) {
  const fs::path archive = EmptyTestFolder();
  Write(archive / "log.yaml");
  Write(archive / "tracked" / "log.yaml");
  EXPECT_THAT(PathsOf(WalkArchive(archive, {})), ElementsAre(".", "tracked"));
}

TEST(WalkArchive, DoesNotTakeImagesForLogs) {
  const fs::path archive = EmptyTestFolder();
  Write(archive / "run" / "log.yaml");
  Write(archive / "run" / "frames.csv");
  Write(archive / "run" / "frames" / "1.png");
  Write(archive / "run" / "frames" / "log.yaml");
  const FoundArchive found = WalkArchive(archive, {});
  EXPECT_THAT(PathsOf(found), ElementsAre("run"));
  EXPECT_TRUE(found.other_files.empty());
}

TEST(WalkArchive, GoesThroughEachFolderOnceByItsOwnName) {
  const fs::path archive = EmptyTestFolder() / "archive";
  Write(archive / "m" / "run" / "log.yaml");
  fs::create_directory_symlink("m", archive / "a");  // before m by its name
  fs::create_directory_symlink(archive, archive / "m" / "circle");
  Write(archive.parent_path() / "elsewhere" / "log.yaml");
  fs::create_directory_symlink(archive.parent_path() / "elsewhere", archive / "z");
  const FoundArchive found = WalkArchive(archive, {});
  EXPECT_THAT(PathsOf(found), ElementsAre("m/run", "z"));
  EXPECT_THAT(found.other_files, ElementsAre(Pair("link to a folder seen already", 2)));
}

TEST(WalkArchive, OpensNoPipesAndDevices) {
  const fs::path archive = EmptyTestFolder();
  mkfifo((archive / "a.csv").c_str(), 0600);
  fs::create_symlink("/dev/zero", archive / "b.csv");
  fs::create_symlink("nowhere", archive / "c.csv");
  fs::create_symlink("d.csv", archive / "d.csv");
  const FoundArchive found = WalkArchive(archive, {});
  EXPECT_TRUE(found.logs.empty());
  EXPECT_THAT(found.other_files,
              ElementsAre(Pair("broken link", 2), Pair("device", 1), Pair("pipe", 1)));
}

TEST(WalkArchive, LeavesOutWhatTheSettingsSay) {
  const fs::path archive = EmptyTestFolder();
  for (const char* name : {"a", "b", "c"}) Write(archive / name / "log.yaml");
  Write(archive / "archive.yaml");
  const FoundArchive found = WalkArchive(archive, {.leave_out = {"[ab]"}});
  EXPECT_THAT(PathsOf(found), ElementsAre("c"));
  EXPECT_THAT(found.other_files, ElementsAre(Pair("left out", 2)));
}

TEST(WalkArchive, RefusesWhatIsNoFolder) {
  const fs::path archive = EmptyTestFolder();
  Write(archive / "file");
  EXPECT_THROW(WalkArchive(archive / "file", {}), InputError);
  EXPECT_THROW(WalkArchive(archive / "nothing", {}), InputError);
}

TEST(WalkArchive, FindsRecordingsByTheirFirstBytes) {
  const fs::path archive = EmptyTestFolder();
  Write(archive / "a.bag", "#ROSBAG V2.0\n");
  Write(archive / "b.0.log", std::string("POCOSIM\0\2\0\0\0\0\0\0\0", 16));
  Write(archive / "c.csv", "time,force\n0,1\n");
  Write(archive / "run" / "log.yaml");
  Write(archive / "run" / "source.bag", "#ROSBAG V2.0\n");
  const FoundArchive found = WalkArchive(archive, {});
  EXPECT_THAT(PathsOf(found), ElementsAre("a.bag", "b.0.log", "run"));
  EXPECT_TRUE(found.logs[0].is_recording);
  EXPECT_FALSE(found.logs[2].is_recording);
  EXPECT_EQ(found.other_files.at(".csv"), 1);
  EXPECT_EQ(found.other_files.at(".bag"), 1);
}

TEST(WalkArchive, TakesFilesAndFoldersThatArchiveYamlImports) {
  const fs::path archive = EmptyTestFolder();
  Write(archive / "dive_1" / "dvl.csv", "time,u\n0,1\n");
  Write(archive / "dive_1" / "thrust.csv", "time,force\n0,1\n");
  Write(archive / "dive_2.csv", "time,u\n0,1\n");
  ArchiveSettings settings;
  settings.imports = {{.files = "dive_1", .map = "one.yaml"}, {.files = "*.csv"}};
  const FoundArchive found = WalkArchive(archive, settings);
  EXPECT_THAT(PathsOf(found), ElementsAre("dive_1", "dive_2.csv"));
  EXPECT_EQ(found.logs[0].map, "one.yaml");
  EXPECT_TRUE(found.other_files.empty());
}

std::string NeedsALog(const fs::path& archive) {
  return ErrorFrom([&] { RequireAnyLog(WalkArchive(archive, {}), archive); });
}

TEST(WalkArchive, SaysWhatIsThereInPlaceOfLogs) {
  const fs::path archive = EmptyTestFolder();
  EXPECT_THAT(NeedsALog(archive), testing::HasSubstr("holds no log (it is empty), expected"));
  Write(archive / "a/notes.txt");
  Write(archive / "b/notes.txt");
  Write(archive / "photo.jpg");
  EXPECT_THAT(NeedsALog(archive), testing::HasSubstr("(but 1 .jpg, 2 .txt), expected"));
  Write(archive / "log/log.yaml");
  EXPECT_EQ(NeedsALog(archive), "no error");
}

}  // namespace
}  // namespace fathom
