// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/read_log.h"

#include "fathom/base/files/output_file.h"

#include <string>

#include "error_from.h"
#include "log_folder.h"
#include "test_folder.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::IsEmpty;
using ::testing::StartsWith;

TEST(ReadLog, ReadsAFolder) {
  const auto folder =
      FolderWith({{"log.yaml",
                   "name: run 7\ndof: [surge, yaw]\nvehicle: rov.yaml\nheld_out: [0.55, 0.65]\n"
                   "notes: calm\ncommand_unit: A\nvideo: a.mp4\nvideo_start: 12.5\ndive: harbour\n"
                   "start: 2026-05-03T14:30:05Z\n"},
                  {"pose.csv", kReadPose}});
  const Log log = ReadLog(folder);
  EXPECT_EQ(log.path, folder);
  EXPECT_EQ(log.name, "run 7");
  EXPECT_THAT(log.dofs, ElementsAre(Dof::kSurge, Dof::kYaw));
  EXPECT_EQ(log.vehicle, "rov.yaml");
  EXPECT_EQ(log.notes, "calm");
  EXPECT_EQ(log.command_unit, "A");
  EXPECT_EQ(log.video, "a.mp4");
  EXPECT_EQ(log.video_start, 12.5);
  EXPECT_EQ(log.dive, "harbour");
  EXPECT_EQ(log.start, 1777818605.0);  // date -u -d 2026-05-03T14:30:05Z +%s
  ASSERT_EQ(log.held_out.size(), 1u);
  EXPECT_EQ(log.held_out[0].from, 0.55);
  EXPECT_EQ(log.held_out[0].to, 0.65);
  EXPECT_THAT(*log.command->Find("tau_surge"), ElementsAre(1, 2, 0));
  EXPECT_THAT(*log.velocity->Find("u"), ElementsAre(0, 0.1, 0.2));
  EXPECT_THAT(*log.pose->Find("z"), ElementsAre(3, 3));
  EXPECT_THAT(TextsOf(log.remarks), IsEmpty());
}

TEST(ReadLog, ReadsAListOfHeldOutIntervals) {
  const Log log = ReadLog(
      FolderWith({{"log.yaml", "name: a\ndof: surge\nheld_out: [[0, 0.55], [0.65, 9]]\n"}}));
  ASSERT_EQ(log.held_out.size(), 2u);
  EXPECT_EQ(log.held_out[1].from, 0.65);
}

TEST(ReadLog, RemarksOnHeldOutTimeWithoutMotion) {
  const Log log =
      ReadLog(FolderWith({{"log.yaml", "name: a\ndof: surge\nheld_out: [100, 200.5]\n"}}));
  EXPECT_THAT(TextsOf(log.remarks),
              ElementsAre("log.yaml: held_out [100, 200.5] holds no sample of the motion."));
}

TEST(ReadLog, TakesTheFinsOutOfTheCommand) {
  const Log log =
      ReadLog(FolderWith({{"command.csv", "t,tau_surge,fin_rudder\n0,1,0.2\n1,3,0.4\n"}}));
  EXPECT_THAT(log.command->columns, ElementsAre("tau_surge"));
  EXPECT_THAT(*log.fins->Find("fin_rudder"), ElementsAre(0.2, 0.4));
  EXPECT_TRUE(Holds(log.remarks, RemarkKind::kSurfaces));
  const Log steered = ReadLog(FolderWith({{"command.csv", "t,fin_rudder\n0,0.2\n1,0.4\n"}}));
  EXPECT_FALSE(steered.command);
  EXPECT_TRUE(steered.fins);
}

TEST(ReadLog, ReadsThrusterCommands) {
  const Log log = ReadLog(FolderWith({{"command.csv", "t,thruster_2,thruster_1\n0,1,2\n1,3,4\n"}}));
  EXPECT_THAT(*log.command->Find("thruster_1"), ElementsAre(2, 4));
}

TEST(ReadLog, IgnoresOtherFilesAndRemarksOnOtherColumns) {
  const Log log =
      ReadLog(FolderWith({{"notes.csv", "whatever\n"},
                          {"pose.csv",
                           "t,x,y,z,qx,qy,qz,qw,vx,sx,sy,sz,sroll,spitch,syaw\n"
                           "0.5,1,2,3,0,0,0,1,1,1,1,1,1,1,1\n0.6,1,2,3,0,0,0,1,1,1,1,1,1,1,1\n"}}));
  // The deviations are those of a trajectory file.
  EXPECT_THAT(TextsOf(log.remarks), ElementsAre("pose.csv: 1 further column is not read: vx."));
}

TEST(ReadLog, RefusesAPathThatIsNotThere) {
  EXPECT_EQ(ErrorFrom([&] { ReadLog("no/such/log"); }),
            "no/such/log: there is no such log folder or CSV file. Check the path.");
}

TEST(ReadLog, NamesALogInAFolderThatHoldsSome) {
  const auto folder = EmptyTestFolder();
  for (const char* name : {"run_2", "run_1"}) {
    std::filesystem::create_directory(folder / name);
    WriteFile(folder / name / "log.yaml", "name: run 7\ndof: surge\n");
  }
  EXPECT_EQ(ErrorFrom([&] { ReadLog(folder); }),
            folder.string() + ": holds logs and is none itself, expected one of them: --log=" +
                (folder / "run_1").string() + ". fathom_check --archive=" + folder.string() +
                " checks them all.");
}

TEST(ReadLog, RefusesAFolderThatLacksAFile) {
  EXPECT_THAT(RefusalOf({{"log.yaml", "-"}}),
              AllOf(StartsWith(": holds no log.yaml (name and dof of the log), expected a log "
                               "folder. fathom init "),
                    EndsWith(" writes what it lacks. See docs/file_formats.md.")));
  EXPECT_EQ(RefusalOf({{"command.csv", "-"}}),
            ": holds no command.csv, expected the commanded forces: only fathom_track, and "
            "fathom_identify, fathom_compare, fathom_diagnose and fathom_check of a free decay, do "
            "without them. See docs/file_formats.md.");
  EXPECT_EQ(
      RefusalOf({{"velocity.csv", "-"}}),
      ": holds neither velocity.csv nor pose.csv nor detections.csv, expected the vehicle's motion "
      "in one of them. Images become detections and poses by fathom_track.");
}

TEST(ReadLog, ReadsImagesOfALogWithoutCommand) {
  const auto folder = FolderWith({{"velocity.csv", "-"}, {"command.csv", "-"}});
  ReadLogOptions options;
  options.may_lack_motion = true;
  options.may_lack_command = true;
  const Log log = ReadLog(folder, options);
  EXPECT_FALSE(log.command || log.velocity || log.pose || log.detections);
}

TEST(ReadLog, RefusesWhatLogYamlMayNotHold) {
  const auto error = [](const std::string& text) { return RefusalOf({{"log.yaml", text}}); };
  EXPECT_EQ(error("dof: surge\n"), "log.yaml:1: key 'name' is missing, expected a text.");
  EXPECT_EQ(error("name: a\n"),
            "log.yaml:1: key 'dof' is missing, expected a text or a list of texts.");
  EXPECT_EQ(
      error("name: a\ndof: [surge, forward]\n"),
      "log.yaml:2: key 'dof' is 'forward', expected one or a list of surge, sway, heave, roll, "
      "pitch, yaw.");
  EXPECT_EQ(error("name: a\ndof: [yaw, yaw]\n"),
            "log.yaml:2: key 'dof' lists 'yaw' twice, expected each once.");
  EXPECT_EQ(
      error("name: a\ndof: yaw\nvehicel: b\n"),
      "log.yaml:3: key 'vehicel' is not known here, expected one of: name, dof, vehicle, notes, "
      "dive, start, held_out, correct, late, mass, command_unit, thruster_unit, video, "
      "video_start, "
      "imported. "
      "Correct or remove "
      "it.");
  EXPECT_EQ(error("name: a\ndof: yaw\nvideo: ../a.mp4\n"),
            "log.yaml:3: key 'video' is '../a.mp4', expected the path of a video from this folder "
            "on.");
  EXPECT_EQ(error("name: a\ndof: yaw\nvideo: /a.mp4\n"),
            "log.yaml:3: key 'video' is '/a.mp4', expected the path of a video from this folder "
            "on.");
  EXPECT_EQ(error("name: a\ndof: yaw\nheld_out: [5, 3.5]\n"),
            "log.yaml:3: key 'held_out' is [5, 3.5], expected [from, to] with from before to.");
  EXPECT_EQ(error("name: a\ndof: yaw\nheld_out: [5]\n"),
            "log.yaml:3: key 'held_out' is a list of 1, expected a list of 2 numbers.");
  EXPECT_EQ(error("name: a\ndof: yaw\nheld_out: [[1, 2], [3, .inf]]\n"),
            "log.yaml:3: key 'held_out[1][1]' is '.inf', expected a finite number.");
  EXPECT_EQ(
      error("name: a\ndof: yaw\nheld_out: 5\n"),
      "log.yaml:3: key 'held_out' is '5', expected a list of 2 numbers, or a list of such lists.");
}

TEST(ReadLog, ReadsAnotherFileAsTheVelocity) {
  const auto folder = FolderWith({{"author.csv", "t,v,extra\n0.5,3,0\n0.6,4,0\n"}});
  const Log log = ReadLog(folder, {.dof = {}, .velocity = "author.csv"});
  EXPECT_THAT(*log.velocity->Find("v"), ElementsAre(3, 4));
  EXPECT_THAT(TextsOf(log.remarks),
              ElementsAre("author.csv: 1 further column is not read: extra.",
                          "velocity.csv: not read, author.csv is in its place."));
  const Log by_path = ReadLog(folder, {.dof = {}, .velocity = folder / "author.csv"});
  EXPECT_THAT(*by_path.velocity->Find("v"), ElementsAre(3, 4));
}

TEST(ReadLog, RefusesAnotherVelocityThatIsNotThere) {
  EXPECT_EQ(RefusalOf({}, {.dof = {}, .velocity = "no_such.csv"}),
            "no_such.csv: there is no such file. Check the path.");
}

TEST(ReadLog, RefusesAnotherVelocityThatCouldBeTwoFiles) {
  const auto folder = FolderWith(
      {{"author.csv", "t,u\n0.5,3\n0.6,4\n"}, {"here/author.csv", "t,u\n0.5,7\n0.6,8\n"}});
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder / "here");
  const std::string text = ErrorFrom([] { ReadLog("..", {.dof = {}, .velocity = "author.csv"}); });
  const Log log = ReadLog("..", {.dof = {}, .velocity = "./../author.csv"});
  std::filesystem::current_path(before);
  EXPECT_EQ(
      text,
      "--velocity=author.csv: there is such a file here and in .., expected one. Give the full "
      "path.");
  EXPECT_THAT(*log.velocity->Find("u"), ElementsAre(3, 4));
}

}  // namespace
}  // namespace fathom
