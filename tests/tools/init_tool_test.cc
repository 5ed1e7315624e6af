// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// A folder of somebody's files, and what fathom_init adds to it.

#include "fathom/import/map/import_map.h"
#include "fathom/import/open_recording.h"
#include "fathom/log/log_yaml.h"
#include "fathom/log/read_log.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "expect_refusal.h"
#include "real_data.h"
#include "run_tool.h"
#include "saved_files.h"
#include "small_log.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using Path = std::filesystem::path;

ToolRun Init(const Path& folder) { return RunToolBinary("fathom_init", {Flag("folder", folder)}); }

// Without the folder, sorted.
std::vector<std::string> NamesIn(const Path& folder) {
  std::vector<std::string> names;
  for (const std::string& file : ListOf(folder)) names.push_back(Path(file).filename().string());
  return names;
}

const Path kRecordings = Path(FATHOM_DATA_DIR) / "recordings";

Path WriteStreams(const Path& folder) {
  WriteTestFile(folder / "command.csv", SmallCommandCsv());
  WriteTestFile(folder / "velocity.csv", SmallVelocityCsv());
  return folder;
}

TEST(InitTool, QuotesAFolderWithASpaceInTheCommandToType) {
  const Path log = WriteStreams(EmptyTestFolder() / "my tank");
  EXPECT_THAT(RunsWell(Init(log)).out,
              HasSubstr("\n  fathom_check --log='" + log.string() + "'\n"));
}

TEST(InitTool, MakesALogOfStreamsThatIdentifies) {
  const Path log = WriteStreams(EmptyTestFolder() / "tank");
  const ToolRun run = RunsWell(Init(log));
  EXPECT_THAT(run.out,
              AllOf(HasSubstr("wrote  " + (log / "log.yaml").string()),
                    HasSubstr("wrote  " + (log / "vehicle.yaml").string()),
                    HasSubstr("\n  fathom_check --log=" + log.string() + "\n")));
  EXPECT_EQ(ReadLog(log).name, "tank");
  EXPECT_THAT(ReadLog(log).dofs, ElementsAre(Dof::kSurge));
  EXPECT_THAT(TextOf(log / "log.yaml"), HasSubstr("#held_out: [45.0, 60.1]"));
  const ToolRun identified = RunsWell("fathom_identify", {Flag("log", log), "--dof=surge"});
  EXPECT_EQ(
      identified.err,
      (log / "vehicle.yaml").string() + " has no mass, so that no inertia is held against it.\n");
}

TEST(InitTool, OverwritesNothing) {
  const Path log = WriteStreams(EmptyTestFolder() / "tank");
  WriteTestFile(log / "log.yaml", "name: mine\ndof: surge\n");
  WriteTestFile(log / "rov.yaml", SmallVehicleYaml());
  const auto before = ListOf(log);
  const ToolRun run = RunsWell(Init(log));
  EXPECT_EQ(ListOf(log), before);
  EXPECT_EQ(TextOf(log / "log.yaml"), "name: mine\ndof: surge\n");
  EXPECT_THAT(run.out,
              AllOf(HasSubstr("kept   " + (log / "log.yaml").string()),
                    HasSubstr("kept   " + (log / "rov.yaml").string()),
                    Not(HasSubstr("wrote"))));
}

TEST(InitTool, NamesTheVehicleFileThatIsThere) {
  const Path log = WriteStreams(EmptyTestFolder() / "tank");
  WriteTestFile(log / "rov.yaml", SmallVehicleYaml());
  RunsWell(Init(log));
  EXPECT_EQ(ReadLog(log).vehicle, "rov.yaml");
}

TEST(InitTool, SaysWhatAnEmptyFolderLacks) {
  const Path folder = EmptyTestFolder();
  const ToolRun run = RunsWell(Init(folder));
  EXPECT_THAT(run.out, AllOf(HasSubstr("command.csv"), HasSubstr("velocity.csv or pose.csv")));
  EXPECT_THAT(NamesIn(folder), ElementsAre("log.yaml", "vehicle.yaml"));
}

// The command that it says next, word for word.
ToolRun RunNext(const std::string& out) {
  std::istringstream words(out.substr(out.rfind("\n  fathom_")));
  std::string tool;
  std::vector<std::string> arguments;
  words >> tool;
  for (std::string word; words >> word;) arguments.push_back(word);
  return RunToolBinary(tool, arguments);
}

TEST(InitTool, WritesAMapForACsvOfAnotherShapeThatImports) {
  const Path folder = EmptyTestFolder();
  std::filesystem::copy(kRecordings / "pool.csv", folder / "pool.csv");
  const ToolRun run = RunsWell(Init(folder));
  EXPECT_THAT(NamesIn(folder), ElementsAre("pool.csv", "pool.csv.map.yaml", "vehicle.yaml"));
  EXPECT_THAT(
      TextOf(folder / "pool.csv.map.yaml"),
      EndsWith(
          RunToolBinary("fathom_import", {Flag("from", folder / "pool.csv"), "--suggest"}).out));
  // Of 240 s.
  EXPECT_THAT(TextOf(folder / "pool.csv.map.yaml"), HasSubstr("\n#held_out: [179.9, 240.0]\n"));
  EXPECT_THAT(run.out, HasSubstr(" --vehicle=" + (folder / "vehicle.yaml").string() + " --out="));
  const ToolRun next = RunsWell(RunNext(run.out));
  EXPECT_THAT(ReadLog(folder / "pool").dofs, ElementsAre(Dof::kSurge));
  EXPECT_THAT(next.out,
              EndsWith("\nnext: fathom_check --log=" + (folder / "pool").string() + "\n"));

  // What was imported is not to be imported again.
  EXPECT_THAT(Init(folder).out,
              EndsWith("\n  fathom_check --log=" + (folder / "pool").string() + "\n"));
}

// A prediction holds no command: a map of it leads nowhere.
TEST(InitTool, LeavesOutAPredictionOfFathomsOwn) {
  const Path folder = EmptyTestFolder();
  std::filesystem::copy(kRecordings / "pool.csv", folder / "pool.csv");
  WriteTestFile(folder / "p.csv", "t,u\n0,0\n0.1,0.01\n");
  const ToolRun run = Init(folder);
  EXPECT_THAT(NamesIn(folder),
              ElementsAre("p.csv", "pool.csv", "pool.csv.map.yaml", "vehicle.yaml"));
  EXPECT_THAT(run.out,
              HasSubstr("note: p.csv: left out: a program of Fathom writes such columns, t,u.\n"));
}

TEST(InitTool, WritesAMapForEachRecording) {
  const Path folder = EmptyTestFolder();
  std::filesystem::copy(kRecordings / "pool.csv", folder / "pool.csv");
  std::filesystem::copy(kRecordings / "pool.mat", folder / "pool.mat");
  RunsWell(Init(folder));
  EXPECT_THAT(
      NamesIn(folder),
      ElementsAre(
          "pool.csv", "pool.csv.map.yaml", "pool.mat", "pool.mat.map.yaml", "vehicle.yaml"));
}

TEST(InitTool, LeavesASingleCsvAsItIs) {
  const Path folder = EmptyTestFolder();
  WriteTestFile(folder / "surge.csv", SmallSingleCsv());
  const ToolRun run = Init(folder);
  EXPECT_THAT(NamesIn(folder), ElementsAre("surge.csv"));
  EXPECT_THAT(run.out, HasSubstr("fathom_check --log=" + (folder / "surge.csv").string()));
}

TEST(InitTool, NamesTheVideoOfACameraLog) {
  const Path folder = EmptyTestFolder();
  WriteTestFile(folder / "command.csv", SmallCommandCsv());
  WriteTestFile(folder / "dive.mp4", "not looked into");
  const ToolRun run = Init(folder);
  EXPECT_EQ(ParseLogYaml("log.yaml", TextOf(folder / "log.yaml")).video, "dive.mp4");
  EXPECT_THAT(run.out, HasSubstr("fathom_track --log=" + folder.string()));
}

TEST(InitTool, SaysThatThrusterSpeedsNeedAVehicle) {
  const Path folder = EmptyTestFolder();
  WriteTestFile(folder / "command.csv", "t,thruster_1,thruster_2,thruster_3\n0,1,2,3\n1,1,2,3\n");
  const ToolRun run = Init(folder);
  EXPECT_THAT(run.out, HasSubstr("holds the speeds of thrusters"));
  EXPECT_THAT(TextOf(folder / "vehicle.yaml"),
              AllOf(HasSubstr("#- {name: thruster_3,"), Not(HasSubstr("thruster_4,"))));
}

TEST(InitTool, SaysWhichStreamCannotBeRead) {
  const Path log = WriteStreams(EmptyTestFolder() / "tank");
  WriteTestFile(log / "velocity.csv", "t,u\n0,nan\n1,0\n");
  const ToolRun run = RunsWell(Init(log));
  EXPECT_THAT(run.out, HasSubstr("note: velocity.csv:2: column 'u' is 'nan'"));
}

TEST(InitTool, TakesTheFolderWithoutItsFlag) {
  const Path log = WriteStreams(EmptyTestFolder() / "tank");
  RunsWell("fathom", {"init", log.string()});
  EXPECT_THAT(NamesIn(log), ElementsAre("command.csv", "log.yaml", "vehicle.yaml", "velocity.csv"));
}

TEST(InitTool, RefusesAFolderThatIsNotThereOrTwo) {
  const Path folder = EmptyTestFolder();
  EXPECT_EQ(
      ExpectRefusal("fathom_init", {Flag("folder", folder / "no")}, folder),
      "fathom_init: " + (folder / "no").string() + ": there is no such folder. Check the path.\n");
  for (const std::vector<std::string>& given : {std::vector<std::string>{"own", "extra"},
                                                {"--folder=own", "extra"},
                                                {"--folder", "own", "extra"}}) {
    EXPECT_EQ(
        ExpectRefusal("fathom_init", given, folder),
        "fathom_init: --folder: is given twice, 'own' and 'extra', expected once. A word that "
        "belongs to no flag is the folder too.\n");
  }
}

class InitToolOnRealRecordings : public OnRealData {};

// A map is worth nothing to the tools before it names a stream.
TEST_F(InitToolOnRealRecordings, SaysThatNoNameTellsWhatIsWhat) {
  const Path folder = EmptyTestFolder();
  std::filesystem::create_symlink(folder_ / "formats" / "rosbag2_cdr_test_0.db3",
                                  folder / "dive.db3");
  const ToolRun run = Init(folder);
  EXPECT_THAT(
      run.out,
      AllOf(HasSubstr("no name of a field tells which stream it is"),
            HasSubstr("fathom_import --from=" + (folder / "dive.db3").string() + " --list")));
  EXPECT_THAT(NamesIn(folder), ElementsAre("dive.db3", "vehicle.yaml"));
}

// Whatever the format: a map that can be read.
TEST_F(InitToolOnRealRecordings, WritesMapsThatCanBeRead) {
  for (const char* name : {"formats/bin/ardusub_4.5_sitl_visp.BIN",
                           "formats/ardusub_small.tlog",
                           "formats/ulog/sample_log_small.ulg",
                           "formats/bags/auv_dvl_imu.bag",
                           "formats/evo_nav2_turtlebot.mcap",
                           "formats/matlab_v5.mat",
                           "formats/pocolog/surge_20150702_forces_torques.0.log"}) {
    const Path folder = EmptyTestFolder();
    const Path recording = folder_ / name;
    std::filesystem::create_symlink(recording, folder / recording.filename());
    RunsWell(Init(folder));
    EXPECT_NO_THROW(ReadImportMap(folder / (recording.filename().string() + ".map.yaml"))) << name;
    EXPECT_NO_THROW(ReadVehicleFile(folder / "vehicle.yaml")) << name;
  }
}

}  // namespace
}  // namespace fathom
