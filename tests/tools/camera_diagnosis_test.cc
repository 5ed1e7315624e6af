// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// What fathom_diagnose makes of logs whose poses are a camera's: detections of markers, filmed by
// fathom_synthesize, beside a velocity sensor and alone.

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "bundled_data.h"
#include "expect_refusal.h"
#include "run_tool.h"
#include "saved_files.h"
#include "small_log.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using Path = std::filesystem::path;
using Names = std::set<std::string>;

// A minute and a half of the vehicle of small_log.h ahead of four markers: velocities at 5 mm/s,
// corners at 0.3 px.
Path FilmedLog(const Path& folder,
               const std::string& effects,
               const std::string& tags = kFilms + "wall_four_tags.yaml",
               const std::string& true_tags = "") {
  const Path vehicle = WriteTestFile(folder / "vehicle.yaml", SmallVehicleYaml());
  const Path experiment =
      WriteTestFile(folder / "experiment.yaml",
                    "name: filmed\nduration: 90\ncommand_rate: 10\n"
                    "surge: {control: open_loop, input: {kind: multisine, rms: 12, offset: 1, "
                    "frequency: [0.3, 2], lines: 9}}\n"
                    "velocity: {rate: 10, noise: {surge: 0.005}}\nheld_out: [70, 90]\n");
  std::string film = "camera: " + kFilms + "wall_camera.yaml\ntags: " + tags +
                     "\nmount: " + kFilms +
                     "wall_mount.yaml\nhold: {position: 0.01, angle: 0.005}\n";
  if (!true_tags.empty()) film += "true_tags: " + true_tags + "\n";
  std::vector<std::string> arguments = {
      Flag("vehicle", vehicle),
      Flag("experiment", experiment),
      "--film=" + WriteTestFile(folder / "film.yaml", film).string(),
      Flag("out", folder / "log")};
  if (!effects.empty()) arguments.push_back("--effects=" + effects);
  RunsWell("fathom_synthesize", arguments);
  EXPECT_FALSE(std::filesystem::exists(folder / "log/pose.csv"));
  return folder / "log";
}

nlohmann::json VerdictOn(const Path& log, const std::vector<std::string>& more = {}) {
  const Path file = log.parent_path() / "verdict.json";
  std::vector<std::string> arguments = {Flag("log", log), Flag("verdict", file)};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const ToolRun run = RunsWell("fathom_diagnose", arguments);
  EXPECT_THAT(run.err, HasSubstr("detections.csv: 900 of 900 frames with detections gave a pose"));
  return JsonOf(file);
}

Names CausesIn(const nlohmann::json& verdict) {
  Names names;
  for (const auto& cause : verdict["causes"]) names.insert(cause["effect"].get<std::string>());
  return names;
}

// Within four of its standard deviations, and these tell it to `precision`.
void ExpectParameter(const nlohmann::json& verdict,
                     const char* name,
                     double truth,
                     double precision) {
  const auto& parameter = verdict["causes"][0]["parameters"][name];
  EXPECT_LT(std::abs(parameter["value"].get<double>() - truth),
            4.0 * parameter["std"].get<double>())
      << parameter;
  EXPECT_LT(parameter["std"].get<double>(), precision) << parameter;
}

TEST(CameraDiagnosis, NamesNothingWhereNothingIsMissing) {
  const auto verdict = VerdictOn(FilmedLog(EmptyTestFolder(), ""));
  EXPECT_EQ(verdict["verdict"], "consistent");
  EXPECT_EQ(CausesIn(verdict), Names());
}

// What the track has to say of poses goes with them: one marker seen face on may lose motion.
TEST(CameraDiagnosis, RepeatsWhatTheTrackSaidOfItsPoses) {
  const Path folder = EmptyTestFolder();
  const Path log = FilmedLog(folder, "", kFilms + "wall_one_tag.yaml");
  const Path tracked = folder / "tracked";
  const ToolRun track = RunsWell("fathom_track", {Flag("log", log), Flag("out", tracked)});
  const std::string said = " poses rest on a single marker whose tilt they know to ";
  EXPECT_THAT(track.err, HasSubstr(said));

  const Path verdict = folder / "verdict.json";
  const auto expect_said = [&](const char* tool, std::vector<std::string> more) {
    more.push_back(Flag("log", tracked));
    const ToolRun run = RunToolBinary(tool, more);
    EXPECT_THAT(run.exit_code, ::testing::AnyOf(0, 2)) << tool << ": " << run.err;
    EXPECT_THAT(run.err, HasSubstr("pose.yaml: ")) << tool;
    EXPECT_THAT(run.err, HasSubstr(said)) << tool;
  };
  expect_said("fathom_identify", {"--source=camera", Flag("model", folder / "m.json")});
  expect_said("fathom_compare", {"--families=least_squares"});
  // The diagnosis goes back to the detections and refines the frames together.
  RunsWell("fathom_diagnose", {"--source=camera", Flag("verdict", verdict), Flag("log", tracked)});
  const std::vector<std::string> remarks = JsonOf(verdict)["remarks"];
  EXPECT_THAT(remarks, Contains(HasSubstr("900 of 900 poses are refined together")));
  EXPECT_THAT(remarks, Not(Contains(HasSubstr(said))));
  // Without a calibration there are the poses as they are.
  const Path uncalibrated = folder / "uncalibrated";
  std::filesystem::copy(tracked, uncalibrated, std::filesystem::copy_options::recursive);
  std::filesystem::remove(uncalibrated / "camera.yaml");
  const ToolRun without = RunsWell("fathom_diagnose", {Flag("log", uncalibrated)});
  EXPECT_THAT(without.out, HasSubstr("The frames are not refined together: "));
  EXPECT_THAT(without.out, HasSubstr("Not tried: pose_scale."));

  // Other poses in their place: what is said is not said of them.
  std::ofstream(tracked / "pose.csv", std::ios::app) << "91,0,0,0,0,0,0,1,1,1,1,1,1,1\n";
  EXPECT_EQ(ExpectRefusal("fathom_identify", {Flag("log", tracked)}, folder),
            "fathom_identify: " + (tracked / "pose.yaml").string() +
                ":1: key 'poses' is 900, but pose.csv holds 901, expected remarks on those poses. "
                "Remove this file if pose.csv was replaced.\n");
}

TEST(CameraDiagnosis, NamesAClockThatIsAFifthOfASecondOff) {
  const auto verdict = VerdictOn(FilmedLog(EmptyTestFolder(), "sensor_clock_offset:offset=0.2"));
  EXPECT_EQ(verdict["verdict"], "explained");
  ASSERT_EQ(CausesIn(verdict), Names({"sensor_clock_offset"}));
  ExpectParameter(verdict, "offset", 0.2, 0.01);
}

// A single marker seen face on: frame by frame its poses bear a noise that is large and skewed, and
// lose some of the motion, which would be named as causes that are not there, and drown a bump.
TEST(CameraDiagnosis, IsNotMisledByASingleMarkerSeenFaceOn) {
  const Path folder = EmptyTestFolder();
  const std::string tags = kFilms + "wall_one_tag.yaml";
  const auto verdict = VerdictOn(FilmedLog(folder / "right", "", tags));
  EXPECT_EQ(verdict["verdict"], "consistent");
  EXPECT_EQ(CausesIn(verdict), Names());

  std::string larger = TextOf(tags);
  const std::string side = "size: 0.4,";
  larger.replace(larger.find(side), side.size(), "size: 0.412,");
  const auto size = VerdictOn(
      FilmedLog(folder / "size", "", tags, WriteTestFile(folder / "larger.yaml", larger)));
  EXPECT_EQ(size["verdict"], "explained");
  ASSERT_EQ(CausesIn(size), Names({"pose_scale"}));
  ExpectParameter(size, "error", 1.0 / 1.03 - 1.0, 0.005);
  EXPECT_TRUE(size["heldout_gain"]["is_in_poses"].get<bool>());
  EXPECT_GT(size["heldout_gain"]["low"].get<double>(), 0.0);

  const auto bump = VerdictOn(FilmedLog(folder / "bump", "marker_moved:jump=0.05:time=40", tags));
  EXPECT_EQ(bump["verdict"], "explained");
  ASSERT_EQ(CausesIn(bump), Names({"marker_moved"}));
  ExpectParameter(bump, "jump", 0.05, 0.01);
}

TEST(CameraDiagnosis, NamesABumpedMarkerWithAVelocitySensorAndWithout) {
  const Path log = FilmedLog(EmptyTestFolder(), "marker_moved:jump=0.05:time=40");
  for (const std::vector<std::string>& flags :
       {std::vector<std::string>(), std::vector<std::string>{"--source=camera"}}) {
    SCOPED_TRACE(flags.empty() ? "with velocities" : flags.front());
    const auto verdict = VerdictOn(log, flags);
    EXPECT_EQ(verdict["verdict"], "explained");
    ASSERT_EQ(CausesIn(verdict), Names({"marker_moved"}));
    ExpectParameter(verdict, "jump", 0.05, 0.01);
    // Between the frames that it lies between, give or take what the data say.
    EXPECT_NEAR(verdict["causes"][0]["parameters"]["time"]["value"].get<double>(), 40.0, 0.3);
  }
}

// A vehicle that swings ahead of the markers while it surges, with its DVL 0.3 m to the side of its
// centre: the DVL shows the swings, the camera shows that the vehicle does not follow them.
TEST(CameraDiagnosis, NamesAVelocitySensorOffTheCentre) {
  const Path folder = EmptyTestFolder();
  const Path vehicle = WriteTestFile(
      folder / "vehicle.yaml",
      SmallVehicleYaml() + "  yaw: {inertia: 6, quadratic_damping: 8, linear_damping: 3}\n");
  const Path experiment = WriteTestFile(
      folder / "experiment.yaml",
      "name: filmed\nduration: 90\ncommand_rate: 10\n"
      "surge: {control: open_loop, input: {kind: multisine, rms: 12, offset: 1, "
      "frequency: [0.3, 2], lines: 9}}\n"
      "yaw: {control: closed_loop, setpoint: {kind: multisine, rms: 0.04, frequency: [0.5, 2], "
      "lines: 7}, pid: {kp: 60, ki: 5, kd: 30, limit: 40}}\n"
      "velocity: {rate: 10, noise: {surge: 0.005, yaw: 0.002}}\nheld_out: [70, 90]\n");
  const Path film = WriteTestFile(folder / "film.yaml",
                                  "camera: " + kFilms + "wall_camera.yaml\ntags: " + kFilms +
                                      "wall_four_tags.yaml\nmount: " + kFilms +
                                      "wall_mount.yaml\nhold: {position: 0.01, angle: 0.005}\n");
  const Path log = folder / "log";
  RunsWell("fathom_synthesize",
           {Flag("vehicle", vehicle),
            Flag("experiment", experiment),
            Flag("film", film),
            "--effects=surge.lever_arm:arm=0.3",
            Flag("out", log)});
  const Path file = folder / "verdict.json";
  RunsWell("fathom_diagnose", {Flag("log", log), "--dof=surge", Flag("verdict", file)});
  const nlohmann::json verdict = JsonOf(file);
  EXPECT_EQ(verdict["verdict"], "explained");
  ASSERT_EQ(CausesIn(verdict), Names({"lever_arm"}));
  ExpectParameter(verdict, "arm", 0.3, 0.03);
}

// Without velocities a scale is not seen and the model bears it, as the remark says; a clock is a
// delay of the command.
TEST(CameraDiagnosis, SaysWhatACameraAloneCannotTell) {
  const Path folder = EmptyTestFolder();
  const Path log = FilmedLog(folder, "sensor_clock_offset:offset=0.2,pose_scale:error=-0.1");
  std::filesystem::remove(log / "velocity.csv");
  const auto verdict = VerdictOn(log);
  EXPECT_THAT(verdict["remarks"].get<std::vector<std::string>>(),
              Contains(HasSubstr("a scale of 1 + e divides inertia and linear damping by 1 + e and "
                                 "quadratic damping by its square")));
  ASSERT_EQ(verdict["causes"].size(), 1u);
  const auto& cause = verdict["causes"][0];
  Names group = {cause["effect"].get<std::string>()};
  for (const auto& other : cause["alternatives"]) group.insert(other.get<std::string>());
  EXPECT_THAT(group, Contains("time_offset"));
  EXPECT_FALSE(group.contains("pose_scale"));
  EXPECT_FALSE(group.contains("sensor_clock_offset"));
  const auto& inertia = verdict["extended"]["parameters"]["inertia"];
  EXPECT_LT(std::abs(inertia["value"].get<double>() - 40.0 / 0.9),
            4.0 * inertia["std"].get<double>());
  EXPECT_LT(inertia["std"].get<double>(), 1.0);
}

// Velocities alone do not show the bump; and poses that nothing can be made of only cost the poses.
TEST(CameraDiagnosis, GoesByTheVelocitiesWhereTheyAreAskedForOrAllThereIs) {
  const Path folder = EmptyTestFolder();
  const Path log = FilmedLog(folder, "marker_moved:jump=0.05:time=40");
  const ToolRun by_velocity =
      RunsWell("fathom_diagnose", {Flag("log", log), "--source=pose_estimator"});
  EXPECT_THAT(by_velocity.out, StartsWith("surge: consistent\n"));

  std::filesystem::remove(log / "camera.yaml");
  const ToolRun without = RunsWell("fathom_diagnose", {Flag("log", log)});
  EXPECT_THAT(without.err, HasSubstr("The camera is not used: "));
  EXPECT_THAT(without.out, StartsWith("surge: consistent\n"));

  EXPECT_THAT(ExpectRefusal("fathom_diagnose", {Flag("log", log), "--source=camera"}, folder),
              HasSubstr("camera.yaml"));
  EXPECT_EQ(ExpectRefusal("fathom_diagnose", {Flag("log", log), "--source=dvl"}, folder),
            "fathom_diagnose: --source: is 'dvl', expected pose_estimator or camera.\n");
}

}  // namespace
}  // namespace fathom
