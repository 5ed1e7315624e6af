// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Logs whose motion is in what a camera saw of a marker.

#include "fathom/camera/detections_file.h"
#include "fathom/camera/tags_file.h"
#include "fathom/log/write_log.h"
#include "fathom/simulate/simulate.h"

#include <set>

#include "expect_refusal.h"
#include "run_tool.h"
#include "saved_files.h"
#include "synthetic_views.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

using Path = std::filesystem::path;

const UncoupledModel<double> kTruth = {
    .inertia = 40.0, .quadratic_damping = 30.0, .linear_damping = 5.0, .buoyancy = 0.5};

// Three minutes of surge before four markers, at 10 Hz with corners to 0.3 px: no poses. (Of a
// single marker seen face on, frame-by-frame poses are biased: docs/marker_trajectory.md.)
Path WriteCameraLog(const Path& folder, bool with_velocity = false) {
  Log log;
  log.name = "swing";
  log.dofs = {Dof::kSurge};
  HeldCommand command;
  for (int i = 0; i < 180; ++i) {
    const double sign = (i / 7) % 2 == 0 ? 1.0 : -1.0;
    command.time.push_back(i);
    command.value.push_back(sign * (6.0 + 4.0 * std::sin(0.11 * i)));
  }
  log.command = Stream{command.time, {"tau_surge"}, {command.value}};
  std::vector<double> time(1800);
  for (std::size_t i = 0; i < time.size(); ++i) time[i] = 0.1 * static_cast<double>(i);
  std::vector<double> velocity(time.size()), position(time.size());
  const Simulation simulation(command, time);
  EXPECT_TRUE(simulation.Run(kTruth, {}, velocity, position));
  if (with_velocity) {
    std::normal_distribution<double> noise(0.0, 0.002);
    std::mt19937 sensor(7);
    std::vector<double> measured = velocity;
    for (double& u : measured) u += noise(sensor);
    log.velocity = Stream{time, {"u"}, {measured}};
  }
  WriteLog(folder, log);

  CameraModel camera = SyntheticCamera();
  camera.coefficients[4] = 0.0;
  std::vector<Detection> detections;
  for (std::size_t i = 0; i < time.size(); ++i) {
    Pose pose = OnTheWall(0.3, 0.2);
    pose.translation.x() = position[i] - 0.2;
    for (const Detection& one : ObserveCorners(camera, FourMarkers(), pose, time[i])) {
      detections.push_back(one);
    }
  }
  EXPECT_EQ(detections.size(), 4 * time.size());
  std::mt19937 random(6);
  AddNoise(0.3, &random, &detections);
  WriteDetections(folder / "detections.csv", detections);
  WriteTestFile(folder / "camera.yaml",
                "cam0: {camera_model: pinhole, distortion_model: radtan, resolution: [1280, 960], "
                "intrinsics: [640, 645, 633, 487], "
                "distortion_coeffs: [-0.11, 0.02, 0.0004, -0.0003]}\n");
  WriteTestFile(folder / "tags.yaml", FormatTagsFile(FourMarkers()));
  WriteTestFile(folder / "mount.yaml",
                "body_from_camera: {position: [0.5, 0, 0], quaternion: [0.5, 0.5, 0.5, 0.5]}\n");
  return folder;
}

TEST(CameraLog, IdentifyFindsTheModelFromDetectionsAlone) {
  const Path folder = EmptyTestFolder();
  const Path log = WriteCameraLog(folder / "log");
  const ToolRun run = RunsWell(
      "fathom_identify",
      {Flag("log", log), "--dof=surge", "--source=camera", Flag("model", folder / "model.json")});
  EXPECT_THAT(run.err, HasSubstr("1800 of 1800 frames with detections gave a pose"));
  EXPECT_THAT(run.err, HasSubstr("; corner sigma 0."));
  const auto model = JsonOf(folder / "model.json");
  EXPECT_EQ(model["provenance"]["source"], "camera");
  const auto& inertia = model["parameters"]["inertia"];
  const double error = std::abs(inertia["value"].get<double>() - kTruth.inertia);
  EXPECT_LT(error, 4.0 * inertia["std"].get<double>());
  EXPECT_LT(error, 0.03 * kTruth.inertia);
}

TEST(CameraLog, CompareHasRowsOfBothSources) {
  const Path folder = EmptyTestFolder();
  const Path log = WriteCameraLog(folder / "log", /*with_velocity=*/true);
  const std::vector<std::string> arguments = {Flag("log", log),
                                              "--families=least_squares,output_error",
                                              Flag("json", folder / "rows.json")};
  RunsWell("fathom_compare", arguments);
  std::set<std::string> rows;
  const auto json = JsonOf(folder / "rows.json");
  for (const auto& row : json["rows"]) {
    rows.insert(row["source"].get<std::string>() + " " + row["family"].get<std::string>());
    EXPECT_NEAR(row["parameters"]["inertia"]["value"].get<double>(), kTruth.inertia, 4.0);
  }
  EXPECT_THAT(rows,
              ::testing::ElementsAre("camera least_squares",
                                     "camera output_error",
                                     "pose_estimator least_squares",
                                     "pose_estimator output_error"));

  // Without the calibration the other source is still there, and the loss is told.
  std::filesystem::remove(log / "camera.yaml");
  const ToolRun without = RunsWell("fathom_compare", arguments);
  EXPECT_THAT(without.err, HasSubstr("The camera is not used: "));
  EXPECT_THAT(without.err, HasSubstr("holds no camera.yaml"));
  EXPECT_EQ(JsonOf(folder / "rows.json")["rows"].size(), 2u);
}

TEST(CameraLog, RefusesDetectionsWithoutACalibration) {
  const Path folder = EmptyTestFolder();
  const Path log = WriteCameraLog(folder / "log");
  std::filesystem::remove(log / "mount.yaml");
  for (const char* source : {"--source=camera", "--dof=surge"}) {
    EXPECT_THAT(ExpectRefusal("fathom_identify", {Flag("log", log), source}),
                HasSubstr("holds no mount.yaml (the camera's place on the vehicle)"));
  }
}

}  // namespace
}  // namespace fathom
