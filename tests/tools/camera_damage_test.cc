// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// What the tools say of camera logs that are damaged or do not fit together. Damaged images and
// calibrations that are missing or another camera's: track_tool_test.cc.

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "bundled_data.h"
#include "expect_refusal.h"
#include "run_tool.h"
#include "saved_files.h"
#include "small_log.h"
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

namespace fathom {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

// Two seconds of a vehicle ahead of four markers: detections, or images, and no poses.
fs::path FilmedLog(const fs::path& folder, bool rendered) {
  const fs::path vehicle = WriteTestFile(folder / "vehicle.yaml", SmallVehicleYaml());
  const fs::path experiment =
      WriteTestFile(folder / "experiment.yaml",
                    "name: filmed\nduration: 2\ncommand_rate: 10\nsurge: {control: open_loop, "
                    "input: {kind: sine, amplitude: 20, frequency: 2}}\n"
                    "velocity: {rate: 10, noise: {surge: 0.005}}\n");
  std::vector<std::string> arguments = {Flag("vehicle", vehicle),
                                        Flag("experiment", experiment),
                                        "--film=" + kFilms + "wall_four.yaml",
                                        Flag("out", folder / "log")};
  if (rendered) arguments.push_back("--render");
  RunsWell("fathom_synthesize", arguments);
  return folder / "log";
}

// Every line of detections.csv but the first, as numbers, through `change`.
void ChangeDetections(const fs::path& log,
                      const std::function<void(std::vector<double>*)>& change) {
  CsvColumns table = ReadColumns(log / "detections.csv");
  ASSERT_EQ(table.names.size(), 10u);
  std::string text = fmt::format("{}\n", fmt::join(table.names, ","));
  for (std::vector<double>& row : table.rows) {
    change(&row);
    text += fmt::format("{}\n", fmt::join(row, ","));
  }
  WriteTestFile(log / "detections.csv", text);
}

ToolRun Tracked(const fs::path& log, const fs::path& folder, const fs::path& summary) {
  return RunToolBinary(
      "fathom_track",
      {Flag("log", log), Flag("out", folder / "tracked"), Flag("summary", summary)});
}

TEST(CameraDamage, CountsTheFramesThatATruncatedVideoLacks) {
  const fs::path folder = EmptyTestFolder();
  const fs::path log = FilmedLog(folder, /*rendered=*/true);
  const fs::path video = log / "film.avi";
  {
    cv::VideoWriter writer(video.string(),
                           cv::CAP_FFMPEG,
                           cv::VideoWriter::fourcc('M', 'J', 'P', 'G'),
                           10.0,
                           cv::Size(800, 600),
                           false);
    ASSERT_TRUE(writer.isOpened());
    std::string times = "frame,t\n";
    for (int i = 0; i < 20; ++i) {
      const fs::path image = log / fmt::format("frames/{:06}.png", i);
      writer.write(cv::imread(image.string(), cv::IMREAD_GRAYSCALE));
      times += fmt::format("{},{}\n", i, 0.1 * i);
    }
    WriteTestFile(log / "frame_times.csv", times);
  }
  fs::remove(log / "frames.csv");
  fs::resize_file(video, fs::file_size(video) * 6 / 10);
  std::ofstream(log / "log.yaml", std::ios::app) << "video: film.avi\n";
  const fs::path summary = folder / "track.json";
  const ToolRun run = RunsWell(Tracked(log, folder, summary));
  const auto frames = JsonOf(summary)["frames"];
  const int num_read = 20 - frames["unreadable"].get<int>();
  EXPECT_GT(num_read, 5);
  EXPECT_LT(num_read, 15);
  EXPECT_THAT(run.err,
              HasSubstr(fmt::format("{}: ends after {} frames, expected 20 as {} lists. The video "
                                    "is cut off or damaged.\n",
                                    video.string(),
                                    num_read,
                                    (log / "frame_times.csv").string())));
  EXPECT_EQ(frames["expected"], 20);
  EXPECT_EQ(frames["with_pose"], num_read);
}

TEST(CameraDamage, RefusesCornersInTheOrderOfAMirror) {
  const fs::path folder = EmptyTestFolder();
  const fs::path log = FilmedLog(folder, /*rendered=*/false);
  ChangeDetections(log, [](std::vector<double>* row) {
    std::swap((*row)[2], (*row)[4]);  // bottom-left with bottom-right
    std::swap((*row)[3], (*row)[5]);
    std::swap((*row)[6], (*row)[8]);  // top-right with top-left
    std::swap((*row)[7], (*row)[9]);
  });
  const std::string said =
      ": the corners of 80 of 80 run clockwise in the image, expected bottom-left, "
      "bottom-right, top-right, top-left of the upright tag. Are the images mirrored, or the "
      "corners in another order (OpenCV's aruco starts at the top-left)?\n";
  EXPECT_THAT(
      ExpectRefusal("fathom_track", {Flag("log", log), Flag("out", folder / "tracked")}, folder),
      HasSubstr((log / "detections.csv").string() + said));
  EXPECT_THAT(ExpectRefusal("fathom_identify", {Flag("log", log), "--source=camera"}, folder),
              HasSubstr((log / "detections.csv").string() + said));
}

TEST(CameraDamage, RefusesDetectionsFromFramesOfAnotherSize) {
  const fs::path folder = EmptyTestFolder();
  const fs::path log = FilmedLog(folder, /*rendered=*/false);
  ChangeDetections(log, [](std::vector<double>* row) {
    for (std::size_t i = 2; i < row->size(); ++i) (*row)[i] = 2.5 * (*row)[i];
  });
  EXPECT_THAT(
      ExpectRefusal("fathom_identify", {Flag("log", log), "--source=camera"}, folder),
      HasSubstr("lie outside the camera's image of 800 x 600 pixels or its lens' field. Is this "
                "the calibration of another camera or resolution?\n"));
}

TEST(CameraDamage, CountsDetectionsOfTagsThatAreNotInTheMapAndRefusesIfThereAreNoOthers) {
  const fs::path folder = EmptyTestFolder();
  const fs::path log = FilmedLog(folder, /*rendered=*/false);
  ChangeDetections(log, [](std::vector<double>* row) {
    if ((*row)[1] == 5.0) (*row)[1] = 77.0;
  });
  const fs::path summary = folder / "track.json";
  const ToolRun run = RunsWell(Tracked(log, folder, summary));
  EXPECT_THAT(run.err,
              HasSubstr("Set aside as unknown id: 20 of 80 detections: tags 77 (20 times).\n"));
  EXPECT_EQ(JsonOf(summary)["frames"]["with_pose"], 20);

  ChangeDetections(log, [](std::vector<double>* row) { (*row)[1] += 100.0; });
  EXPECT_THAT(
      ExpectRefusal("fathom_identify", {Flag("log", log), "--source=camera"}, folder),
      HasSubstr(
          "detections.csv: 0 of 20 frames with detections gave a pose, expected at least two."));
}

}  // namespace
}  // namespace fathom
