// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The joint refinement among the families of fathom_compare and fathom_identify.

#include <filesystem>
#include <string>
#include <vector>

#include "expect_refusal.h"
#include "filmed_minute.h"
#include "run_tool.h"
#include "saved_files.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using Path = std::filesystem::path;

// "output_error camera" of each row.
std::vector<std::string> NamesOf(const nlohmann::json& rows) {
  std::vector<std::string> names;
  for (const auto& row : rows) {
    names.push_back(row["family"].get<std::string>() + " " + row["source"].get<std::string>());
  }
  return names;
}

TEST(JointRow, StandsLastInTheTableOfACameraLogAndIsThatOfRefine) {
  const Path folder = EmptyTestFolder();
  const Path log = SynthesizeMinute(folder / "log", "wall.yaml", 40.0, 1);
  const Path json = folder / "rows.json", page = folder / "page.html";
  const ToolRun run =
      RunsWell("fathom_compare", {Flag("log", log), Flag("json", json), Flag("report", page)});
  const auto rows = JsonOf(json)["rows"];
  ASSERT_THAT(NamesOf(rows),
              ElementsAre("least_squares pose_estimator",
                          "adaptive pose_estimator",
                          "output_error pose_estimator",
                          "least_squares camera",
                          "adaptive camera",
                          "output_error camera",
                          "joint camera"));
  EXPECT_THAT(run.out, HasSubstr("Joint, camera"));
  EXPECT_THAT(run.out,
              HasSubstr("note: Joint, camera: minute: Held out and not refined: 96 frames"));
  EXPECT_THAT(TextOf(page), HasSubstr("Joint, camera"));

  const auto& joint = rows.back();
  EXPECT_EQ(joint["usable"], true) << joint["message"];
  const auto& inertia = joint["parameters"]["inertia"];
  EXPECT_NEAR(inertia["value"].get<double>(), kSurgeInertia, 4.0 * inertia["std"].get<double>());
  EXPECT_LT(inertia["std"].get<double>(), 0.005 * kSurgeInertia);
  // Against the velocity sensor, as all rows: its noise of 1 cm/s is 0.8 cm/s mean absolute error.
  EXPECT_NEAR(joint["heldout_mae"].get<double>(), 0.008, 0.002);

  const Path refined = folder / "refined.json";
  RunsWell("fathom_refine", {Flag("log", log), Flag("json", refined)});
  EXPECT_EQ(joint, JsonOf(refined)["rows"].back());

  // Alone if asked for alone, and not there where its source is not.
  RunsWell("fathom_compare", {Flag("log", log), "--families=joint", Flag("json", json)});
  EXPECT_EQ(JsonOf(json)["rows"], nlohmann::json::array({joint}));
  const ToolRun without = RunsWell(
      "fathom_compare", {Flag("log", log), "--sources=pose_estimator", Flag("json", json)});
  EXPECT_EQ(JsonOf(json)["rows"].size(), 3u);
  EXPECT_THAT(without.out, Not(HasSubstr("Joint")));
}

TEST(JointRow, IsIdentifiedByItselfToo) {
  const Path folder = EmptyTestFolder();
  const Path log = SynthesizeMinute(folder / "log", "wall.yaml", 40.0, 1);
  const Path refined = folder / "refined.json", model = folder / "model.json";
  RunToolBinary("fathom_refine", {Flag("log", log), Flag("model", refined)});
  const ToolRun run =
      RunsWell("fathom_identify",
               {Flag("log", log), "--family=joint", "--source=camera", Flag("model", model)});
  EXPECT_THAT(run.out, HasSubstr("surge by joint from camera: "));
  EXPECT_THAT(run.out, HasSubstr("Held out and not refined: "));
  EXPECT_EQ(JsonOf(model)["parameters"], JsonOf(refined)["parameters"]);
  EXPECT_EQ(JsonOf(model)["provenance"]["family"], "joint");
  EXPECT_EQ(JsonOf(model)["provenance"]["source"], "camera");
  RunsWell("fathom_simulate", {Flag("model", model), Flag("log", log)});

  // Several logs, of which the corners are the only motion: one fit of all.
  const Path second = SynthesizeMinute(folder / "second", "wall.yaml", 25.0, 2);
  for (const Path& one : {log, second}) {
    std::filesystem::remove(one / "velocity.csv");
    std::filesystem::remove(one / "pose.csv");
  }
  const Path both = folder / "both.json";
  RunsWell(
      "fathom_identify",
      {"--log=" + log.string() + "," + second.string(), "--family=joint", Flag("model", both)});
  const auto inertia = JsonOf(both)["parameters"]["inertia"];
  EXPECT_NEAR(inertia["value"].get<double>(), kSurgeInertia, 4.0 * inertia["std"].get<double>());
  EXPECT_LT(inertia["std"], JsonOf(model)["parameters"]["inertia"]["std"]);
}

TEST(JointRow, NamesAClockOffsetOfTheCameraThatIsNotApplied) {
  const Path folder = EmptyTestFolder();
  const Path log = SynthesizeMinute(folder / "log", "wall.yaml", 40.0, 1);
  WriteTestFile(log / "camera.yaml",
                "cam0: {camera_model: pinhole, distortion_model: radtan, resolution: [800, 600], "
                "intrinsics: [640, 641, 401.3, 297.6], timeshift_cam_imu: 0.1, "
                "distortion_coeffs: [-0.12, 0.03, 0.0006, -0.0004]}\n");
  const ToolRun run = RunsWell("fathom_identify", {Flag("log", log), "--family=joint"});
  EXPECT_THAT(run.out, HasSubstr("note: minute: camera.yaml: timeshift_cam_imu is 0.1 s and not"));
  std::filesystem::remove(log / "pose.csv");
  const ToolRun from_poses = RunsWell("fathom_identify", {Flag("log", log), "--source=camera"});
  EXPECT_THAT(from_poses.err, HasSubstr("camera.yaml: timeshift_cam_imu is 0.1 s and not"));
}

TEST(JointRow, SaysWhyThereIsNoModel) {
  const Path folder = EmptyTestFolder();
  const Path still = SynthesizeMinute(folder / "still", "wall_four.yaml", 0.0, 3);
  const Path json = folder / "rows.json";
  const ToolRun run =
      RunToolBinary("fathom_compare", {Flag("log", still), "--families=joint", Flag("json", json)});
  EXPECT_EQ(run.exit_code, 2) << run.out;
  const auto row = JsonOf(json)["rows"][0];
  EXPECT_EQ(row["family"], "joint");
  EXPECT_EQ(row["usable"], false);
  EXPECT_NE(row["message"], "");
  EXPECT_THAT(run.out, HasSubstr("! Joint, camera: " + row["message"].get<std::string>()));
}

// The same words and exit code as in every other family, the reason first.
TEST(JointRow, SaysThatAllIsHeldOut) {
  const Path folder = EmptyTestFolder();
  const Path log = SynthesizeMinute(folder / "log", "wall.yaml", 40.0, 1);
  WriteTestFile(log / "log.yaml", "name: minute\ndof: surge\nheld_out: [[0, 100]]\n");
  const std::string here = Flag("log", log);
  const std::string message =
      (log / "log.yaml").string() +
      ": nothing is left to train on: the held-out intervals take all of the data.\n";
  for (const char* family : {"least_squares", "adaptive", "output_error", "joint"}) {
    EXPECT_THAT(ExpectRefusal("fathom_identify", {here, std::string("--family=") + family}, folder),
                EndsWith("fathom_identify: " + message))
        << family;
  }
  EXPECT_THAT(ExpectRefusal("fathom_compare", {here}, folder),
              EndsWith("fathom_compare: " + message));
  EXPECT_EQ(ExpectRefusal("fathom_refine", {here}, folder), "fathom_refine: " + message);
}

TEST(JointRow, WantsCornersAndACalibration) {
  const Path folder = EmptyTestFolder();
  const Path log = SynthesizeMinute(folder / "log", "wall.yaml", 40.0, 1);
  const std::string here = Flag("log", log), joint = "--families=joint";
  EXPECT_THAT(ExpectRefusal("fathom_compare", {here, joint, "--sources=pose_estimator"}, folder),
              HasSubstr("expected the source camera with it"));
  EXPECT_THAT(
      ExpectRefusal("fathom_identify", {here, "--family=joint", "--source=pose_estimator"}, folder),
      HasSubstr("--source: is 'pose_estimator', expected camera"));
  EXPECT_THAT(ExpectRefusal("fathom_identify", {here, "--family=kalman"}, folder),
              HasSubstr("expected one of least_squares, adaptive, output_error, joint."));

  // Without its mount the camera still has the poses of pose.csv, but no joint row; the loss is
  // told.
  std::filesystem::remove(log / "mount.yaml");
  EXPECT_THAT(ExpectRefusal("fathom_compare", {here, joint}, folder),
              HasSubstr("holds no mount.yaml"));
  const Path json = folder / "rows.json";
  const ToolRun run = RunsWell("fathom_compare", {here, Flag("json", json)});
  EXPECT_EQ(JsonOf(json)["rows"].size(), 6u);
  EXPECT_THAT(run.out, HasSubstr("note: Joint, camera: left out: "));
  EXPECT_THAT(run.out, HasSubstr("holds no mount.yaml"));

  std::filesystem::remove(log / "detections.csv");
  for (const char* tool : {"fathom_compare", "fathom_identify"}) {
    const std::string family = tool == std::string("fathom_identify") ? "--family=joint" : joint;
    EXPECT_THAT(ExpectRefusal(tool, {here, family}, folder), HasSubstr("holds no detections.csv"));
  }
}

}  // namespace
}  // namespace fathom
