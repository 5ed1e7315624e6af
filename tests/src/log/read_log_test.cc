// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/read_log.h"

#include "fathom/base/files/output_file.h"
#include "fathom/base/input_error.h"
#include "fathom/log/log.h"
#include "fathom/log/pose_remarks.h"

#include <map>
#include <string>

#include "error_from.h"
#include "test_folder.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

using Files = std::map<std::string, std::string>;

const Files kGood = {{"log.yaml", "name: run 7\ndof: surge\n"},
                     {"command.csv", "t,tau_surge\n0,1\n1,2\n2,0\n"},
                     {"velocity.csv", "t,u\n0.5,0\n0.6,0.1\n0.7,0.2\n"}};

constexpr char kReadPose[] = "t,x,y,z,qx,qy,qz,qw\n0.5,1,2,3,0,0,0,1\n0.6,1,2,3,0.5,0.5,0.5,0.5\n";

std::filesystem::path Folder(const Files& files) {
  const auto folder = EmptyTestFolder();
  for (const auto& [name, text] : files) WriteFile(folder / name, text);
  return folder;
}

// kGood with some files put in place of its own; without those whose text is "-".
Files With(const Files& changes) {
  Files files = kGood;
  for (const auto& [name, text] : changes) {
    files[name] = text;
    if (text == "-") files.erase(name);
  }
  return files;
}

// The message, without the folder in front.
std::string Error(const Files& changes, const ReadLogOptions& options = {}) {
  const auto folder = Folder(With(changes));
  try {
    ReadLog(folder, options);
  } catch (const InputError& error) {
    std::string text = error.what();
    for (std::size_t at; (at = text.find(folder.string() + "/")) != std::string::npos;) {
      text.erase(at, folder.string().size() + 1);
    }
    if (text.starts_with(folder.string())) text.erase(0, folder.string().size());
    return text;
  }
  return "no error";
}

TEST(ReadLog, ReadsAFolder) {
  Files files =
      With({{"log.yaml",
             "name: run 7\ndof: [surge, yaw]\nvehicle: rov.yaml\nheld_out: [0.55, 0.65]\n"
             "notes: calm\ncommand_unit: A\nvideo: a.mp4\nvideo_start: 12.5\ndive: harbour\n"
             "start: 2026-05-03T14:30:05Z\n"},
            {"pose.csv", kReadPose}});
  const auto folder = Folder(files);
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
      Folder(With({{"log.yaml", "name: a\ndof: surge\nheld_out: [[0, 0.55], [0.65, 9]]\n"}})));
  ASSERT_EQ(log.held_out.size(), 2u);
  EXPECT_EQ(log.held_out[1].from, 0.65);
}

TEST(ReadLog, RemarksOnHeldOutTimeWithoutMotion) {
  const Log log =
      ReadLog(Folder(With({{"log.yaml", "name: a\ndof: surge\nheld_out: [100, 200.5]\n"}})));
  EXPECT_THAT(TextsOf(log.remarks),
              ElementsAre("log.yaml: held_out [100, 200.5] holds no sample of the motion."));
}

// Three rates, two of them with factors in log.yaml.
Files Corrected() {
  return With({{"log.yaml", "name: a\ndof: roll\ncorrect: {q: 0.5, p: -1}\n"},
               {"velocity.csv", "t,p,q,r\n0.5,1,2,3\n0.6,-4,6,8\n"}});
}

TEST(ReadLog, MultipliesColumnsAsLogYamlSays) {
  const Log log = ReadLog(Folder(Corrected()));
  EXPECT_THAT(*log.velocity->Find("p"), ElementsAre(-1, 4));
  EXPECT_THAT(*log.velocity->Find("q"), ElementsAre(1, 3));
  EXPECT_THAT(*log.velocity->Find("r"), ElementsAre(3, 8));
  EXPECT_THAT(TextsOf(log.remarks),
              ElementsAre("velocity.csv: p times -1, q times 0.5, as log.yaml says."));
}

TEST(ReadLog, MultipliesAColumnAsAskedInPlaceOfWhatLogYamlSays) {
  const Log log = ReadLog(Folder(Corrected()), {.corrections = {{"q", 3}, {"r", -1}}});
  EXPECT_THAT(*log.velocity->Find("p"), ElementsAre(-1, 4));
  EXPECT_THAT(*log.velocity->Find("q"), ElementsAre(6, 18));
  EXPECT_THAT(*log.velocity->Find("r"), ElementsAre(-3, -8));
  EXPECT_THAT(TextsOf(log.remarks),
              ElementsAre("velocity.csv: p times -1, as log.yaml says.",
                          "velocity.csv: q times 3, r times -1, as --correct says."));
}

// Of u = 10 t and w = 3, u late by 0.25 s: at 0.3 s it is what was written at 0.55 s.
TEST(ReadLog, ReadsALateColumnOffLater) {
  Files files = With({{"log.yaml", "name: a\ndof: surge\nlate: {u: 0.25}\ncorrect: {u: -1}\n"}});
  files["velocity.csv"] = "t,u,w\n0.3,3,3\n0.4,4,3\n0.5,5,3\n0.6,6,3\n0.7,7,3\n";
  const Log log = ReadLog(Folder(files));
  EXPECT_THAT(log.velocity->time, ElementsAre(0.3, 0.4));
  EXPECT_THAT(*log.velocity->Find("u"),
              ElementsAre(DoubleNear(-5.5, 1e-12), DoubleNear(-6.5, 1e-12)));
  EXPECT_THAT(*log.velocity->Find("w"), ElementsAre(3, 3));
  EXPECT_THAT(TextsOf(log.remarks),
              ElementsAre("velocity.csv: u times -1 and 0.25 s earlier, as log.yaml says."));
  const Log early = ReadLog(Folder(files), {.corrections = {{.column = "u", .late = -0.1}}});
  EXPECT_THAT(early.velocity->time, ElementsAre(0.4, 0.5, 0.6, 0.7));
  EXPECT_THAT(early.velocity->Find("u")->front(), DoubleNear(3.0, 1e-12));
  EXPECT_THAT(TextsOf(ReadLog(Folder(files), {.corrections = {{"u", 1}}}).remarks),
              ElementsAre("velocity.csv: u times 1, as --correct says."));
  EXPECT_EQ(Error(files, {.corrections = {{.column = "u", .late = 9.0}}}),
            "--correct: velocity.csv is shorter than its columns are late.");
}

TEST(ReadLog, LeavesAnotherVelocityFileAsItIs) {
  Files files = Corrected();
  files["other.csv"] = "t,p\n0.5,1\n0.6,2\n";
  const Log log = ReadLog(Folder(files), {.velocity = "other.csv"});
  EXPECT_THAT(*log.velocity->Find("p"), ElementsAre(1, 2));
}

TEST(ReadLog, RefusesCorrectionsOfWhatIsNotThere) {
  EXPECT_EQ(Error({}, {.corrections = {{"p", -1}}}),
            "--correct: corrects 'p', which is no column of velocity.csv, expected one of: u.");
  EXPECT_EQ(Error({{"log.yaml", "name: a\ndof: surge\ncorrect: {p: -1}\n"}}),
            "log.yaml: corrects 'p', which is no column of velocity.csv, expected one of: u.");
  EXPECT_THAT(Error({{"velocity.csv", "-"}, {"pose.csv", kReadPose}}, {.corrections = {{"u", -1}}}),
              StartsWith("--correct: corrects columns of velocity.csv, but "));
  const auto error = [](const std::string& factors) {
    return Error({{"log.yaml", "name: a\ndof: surge\ncorrect: " + factors + "\n"}});
  };
  EXPECT_EQ(error("{u: 0}"), "log.yaml:3: key 'correct.u' is 0, expected a factor that is not 0.");
  EXPECT_EQ(error("{u: .inf}"), "log.yaml:3: key 'correct.u' is '.inf', expected a finite number.");
  EXPECT_EQ(error("{up: -1}"),
            "log.yaml:3: key 'correct.up' is not known here, expected one of: u, v, w, p, q, r. "
            "Correct or remove it.");
}

TEST(ReadLog, TakesTheFinsOutOfTheCommand) {
  const Log log =
      ReadLog(Folder(With({{"command.csv", "t,tau_surge,fin_rudder\n0,1,0.2\n1,3,0.4\n"}})));
  EXPECT_THAT(log.command->columns, ElementsAre("tau_surge"));
  EXPECT_THAT(*log.fins->Find("fin_rudder"), ElementsAre(0.2, 0.4));
  EXPECT_TRUE(Holds(log.remarks, RemarkKind::kSurfaces));
  const Log steered = ReadLog(Folder(With({{"command.csv", "t,fin_rudder\n0,0.2\n1,0.4\n"}})));
  EXPECT_FALSE(steered.command);
  EXPECT_TRUE(steered.fins);
}

TEST(ReadLog, ReadsThrusterCommands) {
  const Log log =
      ReadLog(Folder(With({{"command.csv", "t,thruster_2,thruster_1\n0,1,2\n1,3,4\n"}})));
  EXPECT_THAT(*log.command->Find("thruster_1"), ElementsAre(2, 4));
}

TEST(ReadLog, IgnoresOtherFilesAndRemarksOnOtherColumns) {
  const Log log =
      ReadLog(Folder(With({{"notes.csv", "whatever\n"},
                           {"pose.csv",
                            "t,x,y,z,qx,qy,qz,qw,sx,sy,sz,sroll,spitch,syaw\n"
                            "0.5,1,2,3,0,0,0,1,1,1,1,1,1,1\n0.6,1,2,3,0,0,0,1,1,1,1,1,1,1\n"}})));
  EXPECT_THAT(
      TextsOf(log.remarks),
      ElementsAre("pose.csv: 6 further columns are not read: sx, sy, sz, sroll, spitch, syaw."));
}

TEST(ReadLog, RepeatsWhatIsToBeSaidOfThePoses) {
  const std::vector<Remark> remarks = {{RemarkKind::kPoses, "2 poses: \"bad\", say."},
                                       {RemarkKind::kLostMotion, "line\nbreak # [x]"}};
  const std::string yaml = FormatPoseRemarks(remarks, 2);
  EXPECT_EQ(ParsePoseRemarks("pose.yaml", yaml, 2), remarks);
  const Log log = ReadLog(Folder(With({{"pose.csv", kReadPose}, {"pose.yaml", yaml}})));
  EXPECT_THAT(TextsOf(log.remarks),
              ElementsAre("pose.yaml: " + remarks[0].text, "pose.yaml: " + remarks[1].text));
  EXPECT_EQ(log.remarks[1].kind, RemarkKind::kLostMotion);
  // Without poses there is nothing to say.
  EXPECT_THAT(ReadLog(Folder(With({{"pose.yaml", yaml}}))).remarks, IsEmpty());
  EXPECT_THROW(ParsePoseRemarks("pose.yaml", yaml, 3), InputError);
}

TEST(ReadLog, ReadsThePlainSentencesOnPosesOfBefore) {
  const std::string lost =
      "2 poses rest on a single marker whose tilt they know to 0.06 rad: noise of the tilt";
  EXPECT_THAT(ParsePoseRemarks("pose.yaml", "poses: 2\nremarks: [a, '" + lost + "']\n", 2),
              ElementsAre(Remark{RemarkKind::kPoses, "a"}, Remark{RemarkKind::kLostMotion, lost}));
  EXPECT_THAT(ParsePoseRemarks("pose.yaml", "poses: 2\nremarks: []\n", 2), IsEmpty());
}

TEST(ReadLog, RefusesARemarkOfAnUnknownKind) {
  const std::string yaml = "poses: 2\nremarks: [{kind: loud, text: a}]\n";
  EXPECT_EQ(ErrorFrom([&] { ParsePoseRemarks("pose.yaml", yaml, 2); }),
            "pose.yaml:2: key 'remarks[0].kind' is 'loud', expected poses or lost_motion.");
}

TEST(ReadLog, ReadsASingleCsvOfTheGivenDof) {
  const auto file = Folder({{"run.csv", "t,tau,v,n\n0,1,0.5,7\n0.1,2,0.6,7\n"}}) / "run.csv";
  const Log log = ReadLog(file, {.dof = Dof::kYaw, .velocity = {}});
  EXPECT_EQ(log.name, "run");
  EXPECT_THAT(log.dofs, ElementsAre(Dof::kYaw));
  EXPECT_THAT(log.command->time, ElementsAre(0, 0.1));
  EXPECT_THAT(*log.command->Find("tau_yaw"), ElementsAre(1, 2));
  EXPECT_THAT(*log.velocity->Find("r"), ElementsAre(0.5, 0.6));
  EXPECT_THAT(TextsOf(log.remarks), ElementsAre("run.csv: 1 further column is not read: n."));
}

TEST(ReadLog, ReadsASingleCsvOfAFreeDecayWhereNoCommandIsNeeded) {
  const auto file = Folder({{"run.csv", "t,v\n0,0.5\n0.1,0.6\n"}}) / "run.csv";
  const Log log = ReadLog(file, {.dof = Dof::kYaw, .may_lack_command = true});
  EXPECT_FALSE(log.command.has_value());
  ASSERT_TRUE(log.velocity.has_value());
  EXPECT_EQ(log.velocity->columns, std::vector<std::string>{"r"});
  EXPECT_THROW(ReadLog(file, {.dof = Dof::kYaw}), InputError);
}

TEST(ReadLog, PutsTheSpeedOfASingleCsvRight) {
  const auto file = Folder({{"run.csv", "t,tau,v\n0,1,0.5\n0.1,2,0.6\n"}}) / "run.csv";
  const Log log = ReadLog(file, {.dof = Dof::kYaw, .corrections = {{"v", -2.0}}});
  EXPECT_THAT(*log.velocity->Find("r"), ElementsAre(-1.0, -1.2));
  EXPECT_THAT(TextsOf(log.remarks), ElementsAre("run.csv: r times -2, as --correct says."));
  EXPECT_EQ(ErrorFrom([&] {
              ReadLog(file, {.dof = Dof::kYaw, .corrections = {{"r", -2.0}}});
            }),
            "--correct: corrects 'r', which is no speed of " + file.string() + ", expected v.");
}

TEST(ReadLog, NeedsTheDofOfASingleCsv) {
  const auto file = Folder({{"run.csv", "t,tau,v\n0,1,0.5\n0.1,2,0.6\n"}}) / "run.csv";
  EXPECT_EQ(
      ErrorFrom([&] { ReadLog(file); }),
      file.string() +
          ": a single CSV (t,tau,v) does not say whose force and speed it holds, expected --dof "
          "with it: --dof=surge, sway, heave, roll, pitch or yaw.");
}

TEST(ReadLog, RefusesAPathThatIsNotThere) {
  EXPECT_EQ(ErrorFrom([&] { ReadLog("no/such/log"); }),
            "no/such/log: there is no such log folder or CSV file. Check the path.");
}

TEST(ReadLog, NamesALogInAFolderThatHoldsSome) {
  const auto folder = Folder({});
  for (const char* name : {"run_2", "run_1"}) {
    std::filesystem::create_directory(folder / name);
    WriteFile(folder / name / "log.yaml", kGood.at("log.yaml"));
  }
  EXPECT_EQ(ErrorFrom([&] { ReadLog(folder); }),
            folder.string() + ": holds logs and is none itself, expected one of them: --log=" +
                (folder / "run_1").string() + ". fathom_check --archive=" + folder.string() +
                " checks them all.");
}

TEST(ReadLog, RefusesAFolderThatLacksAFile) {
  EXPECT_THAT(Error({{"log.yaml", "-"}}),
              AllOf(StartsWith(": holds no log.yaml (name and dof of the log), expected a log "
                               "folder. fathom init "),
                    EndsWith(" writes what it lacks. See docs/file_formats.md.")));
  EXPECT_EQ(Error({{"command.csv", "-"}}),
            ": holds no command.csv, expected the commanded forces: only fathom_track, and "
            "fathom_identify, fathom_compare, fathom_diagnose and fathom_check of a free decay, do "
            "without them. See docs/file_formats.md.");
  EXPECT_EQ(
      Error({{"velocity.csv", "-"}}),
      ": holds neither velocity.csv nor pose.csv nor detections.csv, expected the vehicle's motion "
      "in one of them. Images become detections and poses by fathom_track.");
}

constexpr char kDetections[] =
    "t,tag_id,u0,v0,u1,v1,u2,v2,u3,v3\n"
    "0.5,4,1,2,3,4,5,6,7,8\n0.5,2,1,2,3,4,5,6,7,9\n0.6,4,1,2,3,4,5,6,7,10\n"
    "0.7,4,1,2,3,4,5,6,7,11\n0.7,2,1,2,3,4,5,6,7,12\n";

TEST(ReadLog, ReadsALogOfNothingButDetections) {
  const Log log = ReadLog(Folder(With({{"velocity.csv", "-"}, {"detections.csv", kDetections}})));
  ASSERT_TRUE(log.detections);
  EXPECT_FALSE(log.velocity || log.pose);
  EXPECT_THAT(log.detections->time, ElementsAre(0.5, 0.5, 0.6, 0.7, 0.7));
  EXPECT_THAT(*log.detections->Find("v3"), ElementsAre(8, 9, 10, 11, 12));
  EXPECT_THAT(TextsOf(log.remarks), IsEmpty());
}

TEST(ReadLog, ReadsImagesOfALogWithoutCommand) {
  const auto folder = Folder(With({{"velocity.csv", "-"}, {"command.csv", "-"}}));
  ReadLogOptions options;
  options.may_lack_motion = true;
  options.may_lack_command = true;
  const Log log = ReadLog(folder, options);
  EXPECT_FALSE(log.command || log.velocity || log.pose || log.detections);
}

TEST(ReadLog, RefusesDetectionsItCannotUse) {
  std::string text = kDetections;
  text.replace(text.find("0.6,4"), 5, "0.6,4.5");
  EXPECT_EQ(Error({{"detections.csv", text}}),
            "detections.csv:4: column 'tag_id' is 4.5, expected a whole number from 0 on.");
  text = kDetections;
  text.replace(text.find("0.6,4"), 5, "0.6,-1");
  EXPECT_EQ(Error({{"detections.csv", text}}),
            "detections.csv:4: column 'tag_id' is -1, expected a whole number from 0 on.");
  EXPECT_EQ(Error({{"detections.csv", "t,tag_id,u0\n1,2,3\n"}}),
            "detections.csv:1: column 'v0' is missing, found t, tag_id, u0; expected t, tag_id, "
            "u0, v0, u1, v1, u2, v2, u3, v3.");
  text = kDetections;
  text.replace(text.find("0.7,4"), 5, "0.4,4");
  EXPECT_THAT(Error({{"detections.csv", text}}),
              StartsWith("detections.csv:5: column 't' goes back from 0.6 to 0.4"));
  text = "t,tag_id,u0,v0,u1,v1,u2,v2,u3,v3\n5,4,1,2,3,4,5,6,7,8\n5,3,1,2,3,4,5,6,7,8\n";
  EXPECT_EQ(Error({{"detections.csv", text}}),
            "detections.csv: column 't' is 5 in every row, expected at least two frames.");
  text = "t,tag_id,u0,v0,u1,v1,u2,v2,u3,v3\n50,4,1,2,3,4,5,6,7,8\n51,4,1,2,3,4,5,6,7,8\n";
  EXPECT_THAT(Error({{"detections.csv", text}}), HasSubstr("expected some time in common"));
}

TEST(ReadLog, RefusesAFolderInPlaceOfAStream) {
  const auto folder = Folder(With({{"velocity.csv", "-"}}));
  std::filesystem::create_directories(folder / "velocity.csv");
  EXPECT_EQ(ErrorFrom([&] { ReadLog(folder); }),
            (folder / "velocity.csv").string() + ": is a folder, expected a file.");
}

TEST(ReadLog, RefusesWhatLogYamlMayNotHold) {
  const auto error = [](const std::string& text) { return Error({{"log.yaml", text}}); };
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

TEST(ReadLog, RefusesCommandsThatAreUnclear) {
  EXPECT_EQ(Error({{"command.csv", "t,tau_surge,thruster_1\n0,1,2\n1,1,2\n"}}),
            "command.csv:1: holds both tau_* and thruster_* columns, expected forces or "
            "thrusters. Remove the one that was not commanded.");
  EXPECT_EQ(
      Error({{"command.csv", "t,thruster_1,thruster_3\n0,1,2\n1,1,2\n"}}),
      "command.csv:1: column 'thruster_2' is missing, expected thruster_1 to thruster_2 for 2 "
      "columns.");
  EXPECT_EQ(
      Error({{"command.csv", "t,force\n0,1\n1,1\n"}}),
      "command.csv:1: no column to read, found t, force; expected t and at least one of "
      "tau_surge, tau_sway, tau_heave, tau_roll, tau_pitch, tau_yaw, thruster_1, thruster_2, ..., "
      "fin_<name>, shaft_<name>.");
}

TEST(ReadLog, RefusesPosesThatAreNone) {
  EXPECT_EQ(Error({{"pose.csv", "t,x,y,z,qw,qx,qy\n0,1,2,3,1,0,0\n1,1,2,3,1,0,0\n"}}),
            "pose.csv:1: column 'qz' is missing, expected all of qx, qy, qz, qw for an attitude.");
  EXPECT_EQ(Error({{"pose.csv", "t,x,qx,qy,qz,qw\n0,1,0,0,0,1\n1,1,0,0,0,1\n"}}),
            "pose.csv:1: column 'y' is missing, expected all of x, y, z for a position.");
  EXPECT_THAT(Error({{"pose.csv", "t,roll\n0,1\n1,1\n"}}),
              HasSubstr("at least one of x, y, z, qx, qy, qz, qw"));
  EXPECT_EQ(Error({{"pose.csv", "t,z\n0.5,1\n0.6,1\n"}}), "no error");
  EXPECT_EQ(Error({{"pose.csv", "t,qx,qy,qz,qw\n0.5,0,0,0,1\n0.6,0,0,0,1\n"}}), "no error");
  const std::string header = "t,x,y,z,qx,qy,qz,qw\n0.5,1,2,3,0,0,0,1\n";
  EXPECT_EQ(
      Error({{"pose.csv", header + "0.6,1,2,3,0,0.6,0,0.7\n"}}),
      "pose.csv:3: columns 'qx', 'qy', 'qz', 'qw' have length 0.921954, expected a unit quaternion "
      "(within 0.001). Check the order of the columns.");
  EXPECT_EQ(Error({{"pose.csv", header + "0.6,1,2,3,0,0,0,0\n"}}),
            "pose.csv:3: columns 'qx', 'qy', 'qz', 'qw' have length 0, expected a unit quaternion "
            "(within "
            "0.001). Check the order of the columns.");
  EXPECT_EQ(Error({{"pose.csv", header + "0.6,1,2,3,0,0,0,1.0009\n"}}), "no error");
  EXPECT_THAT(Error({{"pose.csv", header + "0.6,1,2,3,0,0,0,1.0011\n"}}), HasSubstr("1.0011"));
  EXPECT_THAT(Error({{"pose.csv", header + "0.6,1,2,3,1e300,1e300,1e300,1e300\n"}}),
              HasSubstr("pose.csv:3: columns 'qx', 'qy', 'qz', 'qw' have length 2e+300"));
}

TEST(ReadLog, RefusesClocksWithNoTimeInCommon) {
  EXPECT_EQ(
      Error({{"command.csv", "t,tau_surge\n1433350623.5,1\n1433350624.5,2\n"}}),
      "command.csv: column 't' runs from 1433350623.5 to 1433350624.5, but that of velocity.csv "
      "from 0.5 to 0.7, expected some time in common. Put both on one clock.");
  EXPECT_THAT(
      Error({{"pose.csv", "t,x,y,z,qx,qy,qz,qw\n50,1,2,3,0,0,0,1\n51,1,2,3,0,0,0,1\n"}}),
      AllOf(StartsWith("command.csv: column 't' runs from 0 to 2, but that of pose.csv from 50")));
}

TEST(ReadLog, RefusesStampsThatAreNotSeconds) {
  EXPECT_EQ(
      Error({{"velocity.csv", "t,u\n500,0\n600,0.1\n700,0.2\n"}}),
      "velocity.csv: the median step of column 't' is 100, expected between 1e-5 and 10 seconds. "
      "Is it in ms, us or ns? Convert t to seconds.");
  EXPECT_EQ(
      Error({{"velocity.csv", "t,u\n0,0\n2e-6,0.1\n4e-6,0.2\n"}}),
      "velocity.csv: the median step of column 't' is 2e-06, expected between 1e-5 and 10 seconds. "
      "Is it in hours or days? Convert t to seconds.");
  EXPECT_EQ(Error({{"command.csv", "t,tau_surge\n0,1\n1000,2\n2000,0\n"}}),
            "command.csv: the median step of column 't' is 1000, expected between 1e-5 and 10 "
            "seconds. Is "
            "it in ms, us or ns? Convert t to seconds.");
  EXPECT_THAT(Error({{"command.csv", "t,tau_surge\n0,1\n1e-6,2\n1,0\n"}}), "no error");
  EXPECT_THAT(Error({{"command.csv", "t,tau_surge\n0.5,1\n0.500001,2\n0.500002,0\n"}}),
              StartsWith("command.csv: the median step of column 't' is 1"));
}

TEST(ReadLog, AllowsACommandThatIsHeldForLong) {
  EXPECT_EQ(Error({{"command.csv", "t,tau_surge\n0,1\n30,2\n60,0\n"},
                   {"velocity.csv", "t,u\n0,0\n9,0.1\n18,0.2\n27,0.2\n36,0\n"}}),
            "no error");
}

TEST(ReadLog, ReadsAnotherFileAsTheVelocity) {
  const auto folder = Folder(With({{"author.csv", "t,v,extra\n0.5,3,0\n0.6,4,0\n"}}));
  const Log log = ReadLog(folder, {.dof = {}, .velocity = "author.csv"});
  EXPECT_THAT(*log.velocity->Find("v"), ElementsAre(3, 4));
  EXPECT_THAT(TextsOf(log.remarks),
              ElementsAre("author.csv: 1 further column is not read: extra.",
                          "velocity.csv: not read, author.csv is in its place."));
  const Log by_path = ReadLog(folder, {.dof = {}, .velocity = folder / "author.csv"});
  EXPECT_THAT(*by_path.velocity->Find("v"), ElementsAre(3, 4));
}

TEST(ReadLog, RefusesAnotherVelocityThatIsNotThere) {
  EXPECT_EQ(Error({}, {.dof = {}, .velocity = "no_such.csv"}),
            "no_such.csv: there is no such file. Check the path.");
}

TEST(ReadLog, RefusesAnotherVelocityThatCouldBeTwoFiles) {
  const auto folder = Folder(
      With({{"author.csv", "t,u\n0.5,3\n0.6,4\n"}, {"here/author.csv", "t,u\n0.5,7\n0.6,8\n"}}));
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder / "here");
  std::string text = "no error";
  try {
    ReadLog("..", {.dof = {}, .velocity = "author.csv"});
  } catch (const InputError& error) {
    text = error.what();
  }
  const Log log = ReadLog("..", {.dof = {}, .velocity = "./../author.csv"});
  std::filesystem::current_path(before);
  EXPECT_EQ(
      text,
      "--velocity=author.csv: there is such a file here and in .., expected one. Give the full "
      "path.");
  EXPECT_THAT(*log.velocity->Find("u"), ElementsAre(3, 4));
}

TEST(ReadLog, RefusesAnotherVelocityForASingleCsv) {
  const auto file = Folder({{"run.csv", "t,tau,v\n0,1,0.5\n0.1,2,0.6\n"}}) / "run.csv";
  EXPECT_EQ(
      ErrorFrom([&] { ReadLog(file, {.dof = Dof::kSurge, .velocity = "v.csv"}); }),
      "--velocity=v.csv: " + file.string() +
          " is a single CSV with its own speed, expected a log folder. Leave out --velocity.");
}

TEST(ReadLog, NamesTheMissingColumnOfASingleCsv) {
  const auto file = Folder({{"run.csv", "t,tau,u\n0,1,0.5\n0.1,2,0.6\n"}}) / "run.csv";
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
    const auto file = Folder({{"run.csv", text}}) / "run.csv";
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
    const auto file = Folder({{"run.csv", text}}) / "run.csv";
    EXPECT_THAT(ErrorFrom([&] { ReadLog(file, {.dof = Dof::kSurge, .velocity = {}}); }),
                HasSubstr(mistake));
  }
}

TEST(ReadLog, ReportsABadCellWithFileLineAndColumn) {
  EXPECT_EQ(
      Error({{"velocity.csv", "t,u\n0.5,0\n0.6,nan\n"}}),
      "velocity.csv:3: column 'u' is 'nan', expected a finite number. Remove the row or repair it "
      "upstream; this reader does not guess.");
}

}  // namespace
}  // namespace fathom
