// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// A marker leaves the view, for a while none is seen, and another one enters: fathom_track on
// images, fathom_refine on corners.

#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "bundled_data.h"
#include "run_tool.h"
#include "saved_files.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;
using Path = std::filesystem::path;

constexpr double kHeaveInertia = 1511.53;  // [kg], of data/vehicles/flatfish.yaml

// Two markers of 0.4 m, 2 m apart one above the other, 3.5 m ahead of a camera that sees 2.2 m of
// height there: the upper one in full down to a depth of 0.3 m, the lower one from 0.5 m on, none
// in between. True poses in pose.csv.
Path SynthesizedFilm(const Path& folder,
                     const std::string& experiment,
                     const std::string& film,
                     std::vector<std::string> more = {}) {
  WriteTestFile(folder / "camera.yaml",
                "image_width: 800\nimage_height: 400\ncamera_name: letterbox\n"
                "camera_matrix: {rows: 3, cols: 3, data: [640, 0, 399.3, 0, 640, 199.6, 0, 0, 1]}\n"
                "distortion_model: plumb_bob\n"
                "distortion_coefficients: {rows: 1, cols: 5, data: [-0.05, 0.01, 0, 0, 0]}\n");
  WriteTestFile(folder / "tags.yaml",
                "family: tag36h11\ntags:\n"
                "  - {id: 4, size: 0.4, world_from_tag: {position: [4.5, 0, -0.6], quaternion: "
                "[0.5, 0.5, 0.5, 0.5]}}\n"
                "  - {id: 5, size: 0.4, world_from_tag: {position: [4.5, 0, 1.4], quaternion: "
                "[0.5, 0.5, 0.5, 0.5]}}\n");
  WriteTestFile(folder / "film.yaml",
                "camera: camera.yaml\ntags: tags.yaml\nmount: " + kData +
                    "/films/wall_mount.yaml\nrate: 10\n" + film);
  WriteTestFile(folder / "experiment.yaml",
                "name: handover\ncommand_rate: 10\npose: {rate: 10}\n" + experiment);
  more.insert(more.end(),
              {"--vehicle=" + kData + "/vehicles/flatfish.yaml",
               Flag("experiment", folder / "experiment.yaml"),
               Flag("film", folder / "film.yaml"),
               Flag("out", folder / "log")});
  RunsWell("fathom_synthesize", more);
  return folder / "log";
}

// Which markers are seen at each stamp of detections.csv.
std::map<double, std::set<int>> SeenIn(const Path& log) {
  const CsvColumns detections = ReadColumns(log / "detections.csv");
  const auto t = detections.Values("t"), id = detections.Values("tag_id");
  std::map<double, std::set<int>> seen;
  for (std::size_t i = 0; i < t.size(); ++i) seen[t[i]].insert(static_cast<int>(id[i]));
  return seen;
}

// How often the marker in view is another one than before.
int HandoversIn(const std::map<double, std::set<int>>& seen) {
  int num_handovers = 0;
  const std::set<int>* last = nullptr;
  for (const auto& [t, markers] : seen) {
    EXPECT_EQ(markers.size(), 1u) << "both are seen at " << t << " s";
    if (last != nullptr && *last != markers) ++num_handovers;
    last = &markers;
  }
  return num_handovers;
}

// Errors of the coordinate `axis` of the poses in `found`, over the standard deviations beside
// them.
std::vector<double> ErrorsOverStd(const Path& found, const Path& truth, const std::string& axis) {
  const CsvColumns is = ReadColumns(found), was = ReadColumns(truth);
  std::map<double, double> true_at;
  const auto true_t = was.Values("t"), true_value = was.Values(axis);
  for (std::size_t i = 0; i < true_t.size(); ++i) true_at[true_t[i]] = true_value[i];
  std::vector<double> errors;
  const auto t = is.Values("t"), value = is.Values(axis), std = is.Values("s" + axis);
  for (std::size_t i = 0; i < t.size(); ++i)
    errors.push_back((value[i] - true_at.at(t[i])) / std[i]);
  return errors;
}

TEST(Handover, TrackGoesOnWithTheNextMarkerAndCountsTheGap) {
  const Path folder = EmptyTestFolder();
  const Path log = SynthesizedFilm(folder,
                                   "duration: 4\nheave: {control: open_loop, initial_speed: 0.4, "
                                   "input: {kind: sine, amplitude: 0, frequency: 1}}\n",
                                   "exposure: 0.01\nwater: {attenuation: 0.1, noise: 2}\n",
                                   {"--render"});
  const Path tracked = folder / "tracked", summary = folder / "track.json";
  const ToolRun run =
      RunsWell("fathom_track", {Flag("log", log), Flag("out", tracked), Flag("summary", summary)});
  const auto seen = SeenIn(tracked);
  EXPECT_EQ(HandoversIn(seen), 1);
  const int num_empty = 40 - static_cast<int>(seen.size());
  EXPECT_GE(num_empty, 5);  // 0.2 m at less than 0.4 m/s
  const auto frames = JsonOf(summary)["frames"];
  EXPECT_EQ(frames["expected"], 40);
  // A tag half out of the image may be read with wrong bits: seen, but of no use.
  const int num_unused = static_cast<int>(frames["times_with_unused_tags_only"].size());
  EXPECT_LE(num_unused, 2);
  EXPECT_EQ(frames["without_tags"], num_empty - num_unused);
  EXPECT_EQ(frames["times_without_tags"].size(), frames["without_tags"].get<std::size_t>());
  EXPECT_THAT(run.err, HasSubstr(std::to_string(num_empty) + " of 40 frames have no detection."));
  // A marker that just touches the image's edge may be set aside, on either side of the gap.
  const auto num_refused = frames["times_without_pose"].size();
  EXPECT_LE(num_refused, 2u);
  EXPECT_EQ(frames["with_pose"], seen.size() - num_refused);

  for (const std::string axis : {"x", "y", "z"}) {
    const auto errors = ErrorsOverStd(tracked / "pose.csv", log / "pose.csv", axis);
    EXPECT_EQ(errors.size(), seen.size() - num_refused);
    for (const double error : errors) EXPECT_LT(std::abs(error), 5.0) << axis;
  }
  for (const double std : ReadColumns(tracked / "pose.csv").Values("sz")) EXPECT_LT(std, 0.02);
}

TEST(Handover, RefineFitsOneModelAcrossTheGaps) {
  const Path folder = EmptyTestFolder();
  const Path log =
      SynthesizedFilm(folder,
                      "duration: 60\nheave: {control: closed_loop, setpoint: {kind: sine, "
                      "amplitude: 1, frequency: 0.3}, pid: {kp: 3000, ki: 300, kd: 2500, "
                      "limit: 800}}\n",
                      "hold: {position: 0.01, angle: 0.005}\ncorner_sigma: 0.3\n");
  const auto seen = SeenIn(log);
  EXPECT_EQ(HandoversIn(seen), 6);  // a period is 21 s
  const Path json = folder / "rows.json", refined = folder / "refined.csv";
  const ToolRun run = RunsWell("fathom_refine",
                               {Flag("log", log), Flag("json", json), Flag("trajectory", refined)});
  EXPECT_THAT(run.out,
              HasSubstr("About " + std::to_string(600 - seen.size()) +
                        " frames in between are without a pose"));
  const auto file = JsonOf(json);
  ASSERT_EQ(file["joint"]["runs"].size(), 1u);  // gaps below 30 s do not cut a run
  EXPECT_EQ(file["joint"]["runs"][0]["num_frames"], seen.size());
  const auto inertia = file["rows"].back()["parameters"]["inertia"];
  const double std = inertia["std"];
  EXPECT_NEAR(inertia["value"].get<double>(), kHeaveInertia, 4.0 * std);
  EXPECT_LT(std, 0.01 * kHeaveInertia);
  // The depth of all frames follows from a handful of numbers, the model's: few are independent.
  const auto errors = ErrorsOverStd(refined, log / "pose.csv", "z");
  ASSERT_EQ(errors.size(), seen.size());
  double squares = 0.0;
  for (const double error : errors) squares += error * error / static_cast<double>(errors.size());
  EXPECT_LT(std::sqrt(squares), 3.0);
  for (const double sz : ReadColumns(refined).Values("sz")) EXPECT_LT(sz, 0.02);
}

}  // namespace
}  // namespace fathom
