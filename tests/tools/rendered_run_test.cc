// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Images in, parameters out, one command per step: docs/rendered_runs.md in small.

#include <cmath>
#include <filesystem>
#include <iterator>
#include <set>
#include <string>

#include "run_tool.h"
#include "saved_files.h"
#include "small_log.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;
using Path = std::filesystem::path;

// Twenty seconds of the vehicle of small_log.h in surge before one marker of 0.4 m, which a camera
// of 320 x 240 pixels sees about 57 pixels wide; 10 frames a second.
Path RenderedLog(const Path& folder) {
  WriteTestFile(folder / "camera.yaml",
                "image_width: 320\nimage_height: 240\ncamera_name: small\n"
                "camera_matrix: {rows: 3, cols: 3, data: [256, 0, 160.3, 0, 257, 119.1, 0, 0, 1]}\n"
                "distortion_model: plumb_bob\n"
                "distortion_coefficients: {rows: 1, cols: 5, data: [-0.1, 0.02, 0, 0, 0]}\n");
  WriteTestFile(folder / "tags.yaml",
                "family: tag36h11\ntags:\n  - {id: 4, size: 0.4, world_from_tag: {position: "
                "[2.8, 0, 0], quaternion: [0.5, 0.5, 0.5, 0.5]}}\n");
  WriteTestFile(folder / "mount.yaml",
                "body_from_camera: {position: [1, 0, 0], quaternion: [0.5, 0.5, 0.5, 0.5]}\n");
  const Path film =
      WriteTestFile(folder / "film.yaml",
                    "camera: camera.yaml\ntags: tags.yaml\nmount: mount.yaml\nrate: 10\n"
                    "exposure: 0.01\nhold: {position: 0.01, angle: 0.005}\nwater: {attenuation: "
                    "0.15, veiling_light: 60, blur: 0.8, noise: 2}\n");
  const Path vehicle = WriteTestFile(folder / "vehicle.yaml", SmallVehicleYaml());
  const Path experiment =
      WriteTestFile(folder / "experiment.yaml",
                    "name: rendered\nduration: 20\ncommand_rate: 10\n"
                    "surge: {control: open_loop, input: {kind: square, amplitude: 12, offset: 1, "
                    "frequency: 1.5}, initial_speed: -0.3}\n"
                    "velocity: {rate: 10, noise: {surge: 0.01}}\n");
  RunsWell("fathom_synthesize",
           {Flag("vehicle", vehicle),
            Flag("experiment", experiment),
            Flag("film", film),
            "--render",
            Flag("out", folder / "log")});
  return folder / "log";
}

// Four standard deviations of the truth, and these tell it to 2 %.
void ExpectInertia(const nlohmann::json& parameters) {
  const auto& inertia = parameters["inertia"];
  EXPECT_LT(std::abs(inertia["value"].get<double>() - 40.0), 4.0 * inertia["std"].get<double>())
      << inertia;
  EXPECT_LT(inertia["std"].get<double>(), 0.8) << inertia;
}

TEST(RenderedRun, GivesTheModelInOneCommandPerStep) {
  const Path folder = EmptyTestFolder();
  const Path log = RenderedLog(folder), tracked = folder / "tracked";
  const ToolRun track = RunsWell("fathom_track", {Flag("log", log), Flag("out", tracked)});
  EXPECT_THAT(track.out, HasSubstr("frames with a pose  200 (100.0 %)"));

  const Path model = folder / "model.json";
  RunsWell("fathom_identify", {Flag("log", tracked), "--source=camera", Flag("model", model)});
  ExpectInertia(JsonOf(model)["parameters"]);

  RunsWell("fathom_compare", {Flag("log", tracked), Flag("json", folder / "rows.json")});
  std::set<std::string> sources;
  const auto rows = JsonOf(folder / "rows.json");
  for (const auto& row : rows["rows"]) {
    sources.insert(row["source"].get<std::string>());
  }
  EXPECT_EQ(sources, std::set<std::string>({"camera", "pose_estimator"}));

  const Path joint = folder / "joint.json";
  RunsWell("fathom_refine", {Flag("log", tracked), "--dof=surge", Flag("model", joint)});
  ExpectInertia(JsonOf(joint)["parameters"]);
}

// A log of nothing but a command and images.
TEST(RenderedRun, IsTrackedByABatch) {
  const Path folder = EmptyTestFolder();
  const Path archive = folder / "archive";
  std::filesystem::create_directory(archive);
  std::filesystem::rename(RenderedLog(folder), archive / "log");
  for (const char* file : {"velocity.csv", "pose.csv", "detections.csv"}) {
    std::filesystem::remove(archive / "log" / file);
  }
  const auto before = std::distance(std::filesystem::recursive_directory_iterator(archive), {});
  const Path csv = folder / "fits.csv";
  const ToolRun run = RunsWell("fathom_batch",
                               {Flag("archive", archive),
                                Flag("results", folder / "results.sqlite"),
                                Flag("csv", csv),
                                "--families=output_error",
                                "--diagnose=false",
                                "--strict"});
  EXPECT_THAT(run.out, HasSubstr("1 log in 1 dive: 1 ok\n"));
  EXPECT_THAT(TextOf(csv), HasSubstr("\nlog,surge,output_error,camera,1,inertia,"));
  EXPECT_EQ(std::distance(std::filesystem::recursive_directory_iterator(archive), {}), before);
}

}  // namespace
}  // namespace fathom
