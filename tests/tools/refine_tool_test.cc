// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// fathom_refine on the corners of synthetic runs, whose vehicle and path are known; and what it
// refuses.

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "bundled_data.h"
#include "expect_refusal.h"
#include "filmed_minute.h"
#include "run_tool.h"
#include "saved_files.h"
#include <gmock/gmock.h>
#include <unistd.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

// Made once for all tests of a process, which damage copies of it only.
const fs::path& OneMarkerLog() {
  struct Made {
    fs::path log;
    ~Made() { fs::remove_all(log.parent_path()); }
  };
  static const Made made = {SynthesizeMinute(
      TestFolder().parent_path() / std::to_string(getpid()) / "log", "wall.yaml", 40.0, 1)};
  return made.log;
}

fs::path CopyOfTheLog() {
  const fs::path copy = EmptyTestFolder() / "copy";
  fs::copy(OneMarkerLog(), copy, fs::copy_options::recursive);
  return copy;
}

void ReplaceIn(const fs::path& path, const std::string& from, const std::string& to) {
  std::string text = TextOf(path);
  const auto at = text.find(from);
  ASSERT_NE(at, std::string::npos) << path << ": " << text;
  text.replace(at, from.size(), to);
  WriteTestFile(path, text);
}

nlohmann::json RowOf(const nlohmann::json& file, const std::string& family) {
  for (const auto& row : file["rows"]) {
    if (row["family"] == family) return row;
  }
  ADD_FAILURE() << "no row of " << family;
  return {};
}

TEST(RefineTool, FindsModelAndPathFromOneMarker) {
  const fs::path folder = EmptyTestFolder();
  const ToolRun run = RunsWell("fathom_refine",
                               {"--log=" + OneMarkerLog().string(),
                                "--dof=surge",
                                Flag("json", folder / "rows.json"),
                                Flag("model", folder / "model.json"),
                                Flag("trajectory", folder / "pose.csv"),
                                Flag("report", folder / "page.html")});
  EXPECT_THAT(run.out, HasSubstr("against velocity.csv"));
  EXPECT_THAT(run.out, HasSubstr("Held out and not refined: "));
  EXPECT_THAT(run.out, HasSubstr("pose.csv is not read"));

  const auto json = JsonOf(folder / "rows.json");
  EXPECT_EQ(json["schema"], "fathom-comparison-1");
  ASSERT_EQ(json["rows"].size(), 4);
  const auto joint = RowOf(json, "joint");
  const double inertia = joint["parameters"]["inertia"]["value"];
  const double inertia_std = joint["parameters"]["inertia"]["std"];
  EXPECT_NEAR(inertia, kSurgeInertia, 4.0 * inertia_std);
  EXPECT_LT(inertia_std, 0.005 * kSurgeInertia);
  // A free run with the right model misses what the sensor's noise hides: 1 cm/s is 0.8 cm/s mean
  // absolute error.
  EXPECT_NEAR(joint["heldout_mae"].get<double>(), 0.008, 0.002);
  EXPECT_GT(RowOf(json, "output_error")["parameters"]["inertia"]["std"].get<double>(), inertia_std);
  // Without noise model the corner sigma of the film is 0.3 px; 480 frames: 5 % is four std.
  EXPECT_NEAR(json["joint"]["corner_sigma_px"].get<double>(), 0.3, 0.015);

  // The path against the true one, along the axis that pose.csv knows (the film's slow motion of
  // the other coordinates is not in it): errors as large as the file says.
  const CsvColumns found = ReadColumns(folder / "pose.csv");
  const CsvColumns truth = ReadColumns(OneMarkerLog() / "pose.csv");
  ASSERT_EQ(found.rows.size(), 480);  // 48 s are trained on
  ASSERT_EQ(found.Values("t").front(), truth.Values("t").front());
  const auto is = found.Values("x"), was = truth.Values("x"), std_x = found.Values("sx");
  double squares = 0.0;
  for (std::size_t k = 0; k < is.size(); ++k) {
    squares += std::pow((is[k] - was[k]) / std_x[k], 2) / static_cast<double>(is.size());
    EXPECT_LT(std_x[k], 0.005);
  }
  // The model's few parameters make the errors of all frames: few are independent.
  EXPECT_LT(std::sqrt(squares), 3.0);
  for (const char* name : {"sy", "sz", "sroll", "spitch", "syaw"}) {
    EXPECT_GT(found.Values(name)[100], 0.0) << name;
  }
  EXPECT_THAT(TextOf(folder / "page.html"), HasSubstr("Trajectory and corners"));

  // The model is one that fathom_simulate reads.
  RunsWell("fathom_simulate",
           {Flag("model", folder / "model.json"),
            "--log=" + OneMarkerLog().string(),
            Flag("out", folder / "prediction.csv")});
  EXPECT_EQ(JsonOf(folder / "model.json")["parameters"]["inertia"]["value"].get<double>(), inertia);
  EXPECT_EQ(JsonOf(folder / "model.json")["provenance"]["family"], "joint");
}

TEST(RefineTool, FitsSeveralLogsTogether) {
  const fs::path folder = EmptyTestFolder();
  const fs::path second = SynthesizeMinute(folder / "second", "wall.yaml", 25.0, 2);
  const std::vector<std::string> both = {
      "--log=" + OneMarkerLog().string(), Flag("log", second), "--dof=surge"};
  auto arguments = both;
  arguments.push_back(Flag("json", folder / "rows.json"));
  arguments.push_back(Flag("report", folder / "page.html"));
  RunsWell("fathom_refine", arguments);
  // Both clocks begin at the same time.
  EXPECT_THAT(TextOf(folder / "page.html"), HasSubstr("2 logs, one behind the other"));
  const auto json = JsonOf(folder / "rows.json");
  ASSERT_EQ(json["joint"]["runs"].size(), 2);
  const auto inertia = RowOf(json, "joint")["parameters"]["inertia"];
  EXPECT_NEAR(inertia["value"].get<double>(), kSurgeInertia, 4.0 * inertia["std"].get<double>());

  arguments = both;
  arguments.push_back(Flag("trajectory", folder / "pose.csv"));
  EXPECT_THAT(ExpectRefusal("fathom_refine", arguments, folder),
              HasSubstr("--trajectory: holds the poses of one log"));
}

TEST(RefineTool, RefusesTheSameLogTwice) {
  const fs::path folder = EmptyTestFolder();
  const std::string log = OneMarkerLog().string();
  const std::string again = log + "/../" + OneMarkerLog().filename().string();
  EXPECT_THAT(
      ExpectRefusal("fathom_refine", {"--log=" + log, "--log=" + again, "--dof=surge"}, folder),
      HasSubstr("--log: names " + again + " twice"));
}

TEST(RefineTool, RefusesALogBesideWhatATrackMadeOfIt) {
  const fs::path folder = EmptyTestFolder();
  const std::string log = OneMarkerLog().string();
  const std::string tracked = (folder / "tracked").string();
  RunsWell("fathom_track", {"--log=" + log, "--out=" + tracked});
  EXPECT_THAT(
      ExpectRefusal("fathom_refine", {"--log=" + log, "--log=" + tracked, "--dof=surge"}, folder),
      HasSubstr("hold the same data"));
}

TEST(RefineTool, SaysWhatItMeasuresAgainstWithoutASensor) {
  const fs::path log = CopyOfTheLog();
  fs::remove(log / "velocity.csv");
  fs::remove(log / "pose.csv");
  const ToolRun run = RunsWell("fathom_refine", {Flag("log", log)});
  EXPECT_THAT(run.out, HasSubstr("against the derivative of the PnP poses"));
  EXPECT_THAT(run.out, Not(HasSubstr("pose.csv is not read")));
}

TEST(RefineTool, CountsMarkersThatAreNotInTheMap) {
  const fs::path folder = EmptyTestFolder();
  const fs::path log = SynthesizeMinute(folder / "log", "wall_four.yaml", 15.0, 3);
  ReplaceIn(log / "tags.yaml", "id: 9", "id: 19");
  const ToolRun run = RunsWell("fathom_refine", {Flag("log", log)});
  EXPECT_THAT(run.out, HasSubstr("unknown id"));

  // A gap of 4 s, 40 frames, in what the camera saw.
  const std::string rows = TextOf(log / "detections.csv");
  const auto from = rows.find("\n20.1,"), to = rows.find("\n24.1,");
  ASSERT_LT(from, to);
  ASSERT_NE(to, std::string::npos);
  WriteTestFile(log / "detections.csv", rows.substr(0, from) + rows.substr(to));
  const ToolRun gap = RunsWell("fathom_refine", {Flag("log", log)});
  EXPECT_THAT(gap.out, HasSubstr("About 40 frames in between are without a pose"));
}

TEST(RefineTool, RefusesWhatItCannotUse) {
  const fs::path log = CopyOfTheLog(), folder = log.parent_path();
  const auto refusal = [&](std::vector<std::string> arguments) {
    arguments.push_back(Flag("model", folder / "model.json"));
    return ExpectRefusal("fathom_refine", arguments, folder);
  };
  const std::string here = Flag("log", log);
  EXPECT_THAT(refusal({}), HasSubstr("--log: is missing, expected a log folder"));
  EXPECT_THAT(refusal({here, "--dof=up"}), HasSubstr("--dof: is 'up', expected"));
  EXPECT_THAT(refusal({here, "--dof=sway"}), HasSubstr("tau_sway"));
  EXPECT_THAT(refusal({here, "--initial_guess=joint"}), HasSubstr("--initial_guess: is 'joint'"));
  EXPECT_THAT(refusal({here, "--clock_offset_std=-1"}),
              HasSubstr("--clock_offset_std is -1, expected 0 or more"));
  EXPECT_THAT(refusal({"--log=" + kData + "/flatfish", "--dof=surge"}),
              HasSubstr("holds no detections.csv"));
  ReplaceIn(log / "tags.yaml", "id: 4", "id: 5");
  EXPECT_THAT(refusal({here}), HasSubstr("gave a pose, expected at least 10"));
  fs::remove(log / "mount.yaml");
  EXPECT_THAT(refusal({here}), HasSubstr("holds no mount.yaml"));
  fs::remove(log / "camera.yaml");
  EXPECT_THAT(refusal({here}), HasSubstr("holds no camera.yaml"));
  // Logs of two cameras.
  const fs::path other = folder / "other";
  fs::copy(OneMarkerLog(), other, fs::copy_options::recursive);
  fs::remove(other / "velocity.csv");  // or it would be the same run
  ReplaceIn(other / "camera.yaml", "401.3", "401.4");
  EXPECT_THAT(refusal({"--log=" + OneMarkerLog().string(), Flag("log", other)}),
              HasSubstr("camera.yaml: differs from the first log's"));
}

// Surge, sway and yaw of data/vehicles/planar_rov.yaml at once, 40 s.
fs::path SynthesizePlane(const fs::path& log, const std::string& more = "") {
  std::string text = TextOf(fs::path(kData) / "experiments/film_planar.yaml");
  const auto replace = [&](const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
  };
  replace("duration: 120", "duration: 40");
  replace("[100, 120]", "[30, 40]");
  replace("logged: false", "logged: true");
  const fs::path experiment = WriteTestFile(log.string() + ".yaml", text + more);
  RunsWell("fathom_synthesize",
           {"--vehicle=" + kData + "/vehicles/planar_rov.yaml",
            Flag("experiment", experiment),
            "--film=" + kData + "/films/wall_four_still.yaml",
            Flag("out", log)});
  return log;
}

TEST(RefineTool, RefinesSeveralDofsTogether) {
  const fs::path folder = EmptyTestFolder();
  const fs::path log = SynthesizePlane(folder / "log");
  const std::vector<std::string> arguments = {Flag("log", log),
                                              "--dofs=surge,sway,yaw",
                                              "--structure=coriolis",
                                              "--free=inertia.sway.yaw",
                                              Flag("true_poses", log / "pose.csv"),
                                              Flag("model", folder / "model.json"),
                                              Flag("json", folder / "refinement.json"),
                                              Flag("trajectory", folder / "path.csv")};
  const ToolRun run = RunsWell("fathom_refine", arguments);
  EXPECT_THAT(run.out, HasSubstr("inertia.sway.yaw"));
  EXPECT_THAT(run.out, HasSubstr("No DOF leaves the simulated motion."));
  EXPECT_THAT(run.out, HasSubstr("Path error over 300 frames: "));
  const nlohmann::json model = JsonOf(folder / "model.json");
  EXPECT_EQ(model["schema"], "fathom-model-2");
  EXPECT_EQ(model["provenance"]["family"], "joint");
  EXPECT_NEAR(model["parameters"]["inertia.surge"]["value"].get<double>(), 34.0, 0.34);
  EXPECT_NEAR(model["parameters"]["inertia.sway.yaw"]["value"].get<double>(), 1.6, 0.016);
  EXPECT_GT(model["parameters"]["inertia.surge"]["std"].get<double>(), 0.0);
  const nlohmann::json refinement = JsonOf(folder / "refinement.json");
  EXPECT_EQ(refinement["schema"], "fathom-film-refinement-1");
  EXPECT_EQ(refinement["joint"]["model"]["parameters"], model["parameters"]);
  EXPECT_LT(refinement["joint"]["free_runs"]["train"]["sway"]["nmae"].get<double>(), 0.1);
  const nlohmann::json& path = refinement["path"];
  EXPECT_EQ(path["of_pnp"]["frames"], 300);
  EXPECT_LT(path["refined"]["position"].get<double>(),
            0.5 * path["of_pnp"]["position"].get<double>());
  EXPECT_THAT(TextOf(folder / "path.csv"),
              HasSubstr("t,x,y,z,qx,qy,qz,qw,sx,sy,sz,sroll,spitch,syaw"));
  // As every other model file.
  RunsWell("fathom_simulate", {Flag("model", folder / "model.json"), Flag("log", log)});

  const auto refusal = [&](std::vector<std::string> wrong) {
    wrong.push_back(Flag("log", log));
    wrong.push_back(Flag("model", folder / "none.json"));
    return ExpectRefusal("fathom_refine", wrong, folder);
  };
  EXPECT_THAT(refusal({"--dofs=surge,sway", "--dof=surge"}),
              HasSubstr("--dof: goes with a model of one DOF, expected none beside --dofs"));
  EXPECT_THAT(refusal({"--dofs=surge,sway", "--clock_offset_std=0.1"}),
              HasSubstr("--clock_offset_std: goes with a model of one DOF"));
  EXPECT_THAT(refusal({"--dof=surge", "--structure=full"}),
              HasSubstr("--structure: goes with --dofs"));
  EXPECT_THAT(refusal({"--dof=surge", Flag("true_poses", log / "pose.csv")}),
              HasSubstr("--true_poses: goes with --dofs, expected none without it"));
  EXPECT_THAT(refusal({"--dofs=surge,sway,yaw", Flag("true_poses", log / "velocity.csv")}),
              HasSubstr("velocity.csv"));
}

// The camera sees the water carry the vehicle off: 2 cm a second.
TEST(RefineTool, FindsTheCurrentOfARun) {
  const fs::path folder = EmptyTestFolder();
  const fs::path log = SynthesizePlane(folder / "log", "current: {north: -0.02, east: 0.02}\n");
  RunsWell("fathom_refine",
           {Flag("log", log),
            "--dofs=surge,sway,yaw",
            "--structure=coriolis",
            "--free=inertia.sway.yaw,current.north.film_planar,current.east.film_planar",
            Flag("model", folder / "model.json")});
  const nlohmann::json parameters = JsonOf(folder / "model.json")["parameters"];
  const auto expect = [&](const char* name, double truth) {
    const double std = parameters[name]["std"].get<double>();
    EXPECT_LT(std, 2e-4) << name;
    EXPECT_NEAR(parameters[name]["value"].get<double>(), truth, 4.0 * std) << name;
  };
  expect("current.north.film_planar", -0.02);
  expect("current.east.film_planar", 0.02);
}

TEST(RefineTool, HasNoCoupledModelOfAVehicleThatHardlyTurns) {
  const fs::path folder = EmptyTestFolder();
  // Surge alone is driven.
  const ToolRun run = RunToolBinary("fathom_refine",
                                    {"--log=" + OneMarkerLog().string(),
                                     "--dofs=surge,yaw",
                                     "--structure=diagonal",
                                     Flag("model", folder / "model.json")});
  EXPECT_EQ(run.exit_code, 2) << run.out;
  EXPECT_THAT(run.err, HasSubstr("fathom_refine: no usable model: "));
  EXPECT_FALSE(fs::exists(folder / "model.json"));
}

TEST(RefineTool, HasNoModelOfAVehicleThatStaysPut) {
  const fs::path folder = EmptyTestFolder();
  const fs::path log = SynthesizeMinute(folder / "log", "wall_four.yaml", 0.0, 3);
  std::vector<std::string> arguments = {Flag("log", log),
                                        Flag("model", folder / "model.json"),
                                        Flag("json", folder / "rows.json"),
                                        Flag("report", folder / "page.html")};
  const ToolRun run = RunToolBinary("fathom_refine", arguments);
  EXPECT_EQ(run.exit_code, 2) << run.out;
  EXPECT_THAT(run.err, HasSubstr("fathom_refine: no usable model: "));
  EXPECT_FALSE(fs::exists(folder / "model.json"));
  EXPECT_FALSE(RowOf(JsonOf(folder / "rows.json"), "joint")["usable"].get<bool>());

  arguments.push_back("--initial_guess=least_squares");
  const ToolRun guessed = RunToolBinary("fathom_refine", arguments);
  EXPECT_EQ(guessed.exit_code, 2) << guessed.out;
  EXPECT_THAT(guessed.err, HasSubstr("The initial guess by least_squares is not a usable model: "));
  EXPECT_FALSE(fs::exists(folder / "model.json"));
  EXPECT_FALSE(RowOf(JsonOf(folder / "rows.json"), "joint")["usable"].get<bool>());
}

}  // namespace
}  // namespace fathom
