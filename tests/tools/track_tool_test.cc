// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// fathom_track from rendered images, whose trajectory is known, to poses; and what it refuses.

#include "fathom/log/csv_table.h"

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "expect_refusal.h"
#include "run_tool.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

const std::string kData = FATHOM_DATA_DIR;

std::string Bytes(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

ToolRun Track(const fs::path& log, std::vector<std::string> more) {
  more.push_back("--log=" + log.string());
  return RunToolBinary("fathom_track", more);
}

// Twelve rendered frames of a vehicle in surge in front of four markers, and its true poses in
// pose.csv. Made once for all tests of a process.
const fs::path& RenderedLog() {
  struct Made {
    fs::path log;
    ~Made() { fs::remove_all(log.parent_path()); }
  };
  static const Made made = {[] {
    // Tests may run side by side, each in a process of its own.
    const fs::path folder =
        fs::path(FATHOM_SCRATCH_DIR) / ("TrackTool.rendered." + std::to_string(getpid()));
    const std::string films = kData + "/films/";
    WriteTestFile(folder / "film.yaml",
                  "camera: " + films + "wall_camera.yaml\ntags: " + films +
                      "wall_four_tags.yaml\nmount: " + films +
                      "wall_mount.yaml\nexposure: 0.02\nwater: {attenuation: 0.1, noise: 2}\n");
    WriteTestFile(folder / "experiment.yaml",
                  "name: rendered\nduration: 1.2\ncommand_rate: 10\nsurge: {control: open_loop, "
                  "initial_speed: 0.3, input: {kind: sine, amplitude: 50, frequency: 1}}\npose: "
                  "{rate: 10}\n");
    const ToolRun run = RunToolBinary("fathom_synthesize",
                                      {"--vehicle=" + kData + "/vehicles/flatfish.yaml",
                                       "--experiment=" + (folder / "experiment.yaml").string(),
                                       "--film=" + (folder / "film.yaml").string(),
                                       "--render",
                                       "--out=" + (folder / "log").string()});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return folder / "log";
  }()};
  return made.log;
}

// A copy that a test may damage.
fs::path CopyOfTheLog() {
  const fs::path& log = RenderedLog();
  const fs::path copy = EmptyTestFolder() / "copy";
  fs::copy(log, copy, fs::copy_options::recursive);
  return copy;
}

CsvTable PosesIn(const fs::path& log) {
  CsvSpec spec;
  spec.required = {"x", "y", "z", "qx", "qy", "qz", "qw"};
  spec.at_least_one_of = {"sx", "sy", "sz", "sroll", "spitch", "syaw"};
  return ReadCsvTable(log / "pose.csv", spec);
}

TEST(TrackTool, FindsTheTrajectoryOfRenderedImages) {
  const fs::path& log = RenderedLog();
  const fs::path folder = EmptyTestFolder();
  const ToolRun run = Track(log,
                            {"--out=" + (folder / "tracked").string(),
                             "--summary=" + (folder / "track.json").string(),
                             "--overlay=" + (folder / "sheet.png").string()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("frames with a pose  12 (100.0 %)"));

  CsvSpec spec;
  spec.required = {"x", "y", "z"};
  const CsvTable truth = ReadCsvTable(log / "pose.csv", spec);
  const CsvTable found = PosesIn(folder / "tracked");
  ASSERT_EQ(found.stream.time, truth.stream.time);
  for (const char axis : {'x', 'y', 'z'}) {
    const auto& is = *found.stream.Find(std::string(1, axis));
    const auto& was = *truth.stream.Find(std::string(1, axis));
    const auto& std = *found.stream.Find(std::string("s") + axis);
    for (std::size_t row = 0; row < is.size(); ++row) {
      // Four standard deviations, twelve frames of three numbers.
      EXPECT_LT(std::abs(is[row] - was[row]), 4.0 * std[row]) << axis << " in row " << row;
      EXPECT_LT(std[row], 0.02) << axis;
      EXPECT_GT(std[row], 1e-5) << axis;
    }
  }
  const auto summary = nlohmann::json::parse(Bytes(folder / "track.json"));
  EXPECT_EQ(summary["schema"], "fathom-track-1");
  EXPECT_EQ(summary["frames"]["expected"], 12);
  EXPECT_EQ(summary["frames"]["with_pose"], 12);
  EXPECT_EQ(summary["detections"]["found"], 48);
  EXPECT_LT(summary["fit"]["corner_sigma_px"], 0.15);
  EXPECT_GT(summary["fit"]["corner_sigma_px"], 0.01);
  EXPECT_THAT(Bytes(folder / "sheet.png"), StartsWith("\x89PNG"));
  for (const char* file : {"log.yaml", "command.csv", "camera.yaml", "tags.yaml", "mount.yaml"}) {
    EXPECT_EQ(Bytes(folder / "tracked" / file), Bytes(log / file)) << file;
  }

  // The same poses from the detections alone.
  const ToolRun again = Track(folder / "tracked", {"--out=" + (folder / "again").string()});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  const auto& first = *found.stream.Find("x");
  const CsvTable second_table = PosesIn(folder / "again");
  const auto& second = *second_table.stream.Find("x");
  // Detections are written to 1e-4 px: 1e-4 of the noise.
  for (std::size_t row = 0; row < first.size(); ++row) EXPECT_NEAR(second[row], first[row], 1e-5);
}

TEST(TrackTool, WritesAnOverlayVideo) {
  const fs::path folder = EmptyTestFolder();
  const ToolRun run = Track(
      RenderedLog(),
      {"--out=" + (folder / "tracked").string(), "--overlay=" + (folder / "overlay.avi").string()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(Bytes(folder / "overlay.avi"), StartsWith("RIFF"));
  EXPECT_EQ(ListOf(folder).size(), ListOf(folder / "tracked").size() + 2);
}

TEST(TrackTool, CountsDamagedImagesAndGoesOn) {
  const fs::path log = CopyOfTheLog();
  const fs::path image = log / "frames/000004.png";
  fs::resize_file(image, fs::file_size(image) / 3);
  fs::remove(log / "frames/000005.png");
  const fs::path out = log.parent_path() / "tracked";
  const fs::path summary = log.parent_path() / "track.json";
  const ToolRun run = Track(log, {"--out=" + out.string(), "--summary=" + summary.string()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err,
              HasSubstr((log / "frames.csv").string() + ":6: " + image.string() +
                        ": cannot decode this image: "));
  EXPECT_THAT(run.err, HasSubstr("frames/000005.png: there is no such file. Check the path.\n"));
  const auto json = nlohmann::json::parse(Bytes(summary));
  EXPECT_EQ(json["frames"]["expected"], 12);
  EXPECT_EQ(json["frames"]["unreadable"], 2);
  EXPECT_EQ(json["frames"]["with_pose"], 10);
  EXPECT_EQ(json["frames"]["unreadable_ones"].size(), 2u);
}

TEST(TrackTool, CountsTagsThatAreNotInTheMap) {
  const fs::path log = CopyOfTheLog();
  WriteTestFile(log / "tags.yaml", Bytes(kData + "/films/wall_one_tag.yaml"));
  const fs::path summary = log.parent_path() / "track.json";
  const ToolRun run = Track(
      log, {"--out=" + (log.parent_path() / "tracked").string(), "--summary=" + summary.string()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  // Tags 5 and 6 in twelve frames; tag 9 is of a family that nobody looks for now.
  const auto unused = nlohmann::json::parse(Bytes(summary))["detections"]["sightings_not_used"];
  EXPECT_EQ(unused.size(), 24u);
  EXPECT_EQ(unused[0]["reason"], "is not in the map");
}

TEST(TrackTool, RefusesWhatItCannotUse) {
  const fs::path log = CopyOfTheLog();
  const fs::path folder = log.parent_path();
  const std::string out = "--out=" + (folder / "tracked").string();
  const auto refusal = [&](const fs::path& path, std::vector<std::string> more) {
    more.push_back("--log=" + path.string());
    return ExpectRefusal("fathom_track", more, folder);
  };
  EXPECT_EQ(
      refusal(log, {}),
      "fathom_track: " + (log / "pose.csv").string() +
          ": is there already, expected --overwrite to replace it, or --out for a new log.\n");
  EXPECT_EQ(refusal(folder / "nowhere", {out}),
            "fathom_track: --log=" + (folder / "nowhere").string() +
                ": is no folder, expected a log folder.\n");
  EXPECT_EQ(refusal(log, {out, "--from=video"}),
            "fathom_track: --from: is 'video', expected images or detections.\n");
  EXPECT_EQ(refusal(log, {out, "--from=detections"}),
            "fathom_track: " + log.string() + ": holds no detections.csv. Leave out --from.\n");
  EXPECT_EQ(refusal(log, {out, "--max_hamming=3"}),
            "fathom_track: tag detector: max_hamming is 3, expected 0, 1 or 2.\n");
  EXPECT_EQ(refusal(log, {out, "--gate=0"}),
            "fathom_track: --gate: is 0, expected a number above 0.\n");
  EXPECT_EQ(refusal(log, {out, "--overlay=" + (folder / "sheet.gif").string()}),
            "fathom_track: " + (folder / "sheet.gif").string() +
                ": expected a path that ends in .mp4 or .avi for a video, or in .png for a "
                "contact sheet.\n");
}

TEST(TrackTool, RefusesALogWithoutCalibrationOrWithAnothers) {
  const fs::path log = CopyOfTheLog();
  const fs::path folder = log.parent_path();
  const std::vector<std::string> arguments = {"--log=" + log.string(),
                                              "--out=" + (folder / "tracked").string()};
  const std::string camera = Bytes(log / "camera.yaml");
  std::string half = camera;
  half.replace(half.find("image_width: 800"), 16, "image_width: 700");
  WriteTestFile(log / "camera.yaml", half);
  EXPECT_THAT(ExpectRefusal("fathom_track", arguments, folder),
              HasSubstr((log / "frames/000000.png").string() +
                        ": is 800 x 600 pixels, expected 700 x 600 as in " +
                        (log / "camera.yaml").string()));
  for (const char* file : {"camera.yaml", "tags.yaml", "mount.yaml"}) {
    const std::string text = file == std::string("camera.yaml") ? camera : Bytes(log / file);
    fs::remove(log / file);
    EXPECT_THAT(ExpectRefusal("fathom_track", arguments, folder), HasSubstr(file)) << file;
    WriteTestFile(log / file, text);
  }
  fs::remove(log / "frames.csv");
  EXPECT_EQ(ExpectRefusal("fathom_track", arguments, folder),
            "fathom_track: " + log.string() +
                ": holds no images: no frames.csv, and log.yaml names no video. See "
                "docs/file_formats.md.\n");
}

TEST(TrackTool, SaysWhenNothingIsSeen) {
  const fs::path log = CopyOfTheLog();
  WriteTestFile(log / "tags.yaml",
                "family: tag25h9\ntags: [{id: 1, size: 0.4, world_from_tag: {position: [4, 0, 0], "
                "quaternion: [0.5, 0.5, 0.5, 0.5]}}]\n");
  const fs::path out = log.parent_path() / "tracked";
  const ToolRun run = Track(log, {"--out=" + out.string()});
  EXPECT_EQ(run.exit_code, 2) << run.err;
  EXPECT_THAT(run.err, HasSubstr("fathom_track: no usable trajectory: "));
  EXPECT_FALSE(fs::exists(out));
}

}  // namespace
}  // namespace fathom
