// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// fathom_track from rendered images, whose trajectory is known, to poses; and what it refuses.

#include "fathom/camera/detections_file.h"
#include "fathom/camera/tags_file.h"
#include "fathom/log/csv_table.h"
#include "fathom/log/log.h"
#include "fathom/log/read_log.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "expect_refusal.h"
#include "run_tool.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <unistd.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;
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
  EXPECT_EQ(summary["detections"]["sides_not_followed"], 0);
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

TEST(TrackTool, SaysWhatIsMissingInAnOverlayOfDetections) {
  const fs::path log = CopyOfTheLog();
  const fs::path tracked = log.parent_path() / "tracked";
  ASSERT_EQ(Track(log, {"--out=" + tracked.string()}).exit_code, 0);
  // The fourth row, of the first frame's last tag, a little later; and a frame that is not there.
  std::string csv = Bytes(tracked / "detections.csv");
  std::size_t row = csv.find('\n') + 1;
  for (int i = 0; i < 3; ++i) row = csv.find('\n', row) + 1;
  csv.replace(row, csv.find(',', row) - row, "0.05");
  WriteTestFile(log / "detections.csv", csv);
  fs::remove(log / "frames/000005.png");
  const fs::path again = log.parent_path() / "again";
  const auto overlay = [&](const char* file) {
    return Track(log,
                 {"--from=detections",
                  "--overwrite",
                  "--out=" + again.string(),
                  "--overlay=" + (log.parent_path() / file).string()});
  };
  const ToolRun run = overlay("overlay.avi");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("frames/000005.png: there is no such file. Check the path.\n"));
  EXPECT_THAT(run.err,
              HasSubstr((log / "frames.csv").string() +
                        ": 5 of 48 detections are not drawn, the first at t = 0.05: their stamps "
                        "are of no frame that can be read.\n"));

  fs::remove_all(log / "frames");
  const ToolRun none = overlay("sheet.png");
  EXPECT_EQ(none.exit_code, 1);
  EXPECT_THAT(none.err,
              HasSubstr((log.parent_path() / "sheet.png").string() +
                        ": cannot be made of no frame, expected one at least that can be read."));
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
  EXPECT_THAT(run.out,
              HasSubstr("12 read, 0 unreadable, 0 without tags, 0 with none that is used\n"));
  EXPECT_THAT(run.err,
              HasSubstr("Not used: 24 sightings of a tag that is not in the map: tag36h11 5 (12 "
                        "times), tag36h11 6 (12 times).\n"));
}

// Tags that are seen are not "no tag": their ids and the reason stand on the terminal.
TEST(TrackTool, SaysWhichTagsItSeesWhenNoneIsInTheMap) {
  const fs::path log = CopyOfTheLog();
  WriteTestFile(log / "tags.yaml",
                "family: tag36h11\ntags: [{id: 77, size: 0.4, world_from_tag: {position: [4, 0, "
                "0], quaternion: [0.5, 0.5, 0.5, 0.5]}}]\n");
  const fs::path summary = log.parent_path() / "track.json";
  const ToolRun run = Track(
      log, {"--out=" + (log.parent_path() / "tracked").string(), "--summary=" + summary.string()});
  EXPECT_EQ(run.exit_code, 2) << run.err;
  EXPECT_THAT(run.err, HasSubstr("12 of 12 frames show tags, but none that is used"));
  EXPECT_THAT(run.err,
              HasSubstr("Not used: 36 sightings of a tag that is not in the map: tag36h11 4 (12 "
                        "times), tag36h11 5 (12 times), tag36h11 6 (12 times).\n"));
  EXPECT_THAT(run.err, Not(HasSubstr("no tag")));
  const auto frames = nlohmann::json::parse(Bytes(summary))["frames"];
  EXPECT_EQ(frames["without_tags"], 0);
  EXPECT_EQ(frames["times_with_unused_tags_only"].size(), 12u);
}

// What is written is a log in itself: it names no video or vehicle that is not there.
TEST(TrackTool, WritesALogThatHoldsWhatItNames) {
  const fs::path log = CopyOfTheLog();
  const fs::path folder = log.parent_path();
  const ToolRun tracked =
      Track(log, {"--overlay=" + (folder / "dive.avi").string(), "--overwrite"});
  ASSERT_EQ(tracked.exit_code, 0) << tracked.err;
  const fs::path dive = folder / "dive";
  for (const char* file : {"camera.yaml", "tags.yaml", "mount.yaml", "command.csv"}) {
    WriteTestFile(dive / file, Bytes(log / file));
  }
  fs::rename(folder / "dive.avi", dive / "dive.avi");
  std::string times = "frame,t\n";
  for (int i = 0; i < 12; ++i) times += fmt::format("{},{}\n", i, 0.1 * i);
  WriteTestFile(dive / "frame_times.csv", times);
  WriteTestFile(folder / "rov.yaml", "name: rov\nmass: 20\nsize: [1, 1, 1]\n");
  WriteTestFile(dive / "log.yaml",
                "name: dive\ndof: surge\nvideo: dive.avi\nvehicle: ../rov.yaml\nnotes: still\n");

  const ToolRun run = Track(dive, {"--out=" + (folder / "out").string()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Log out = ReadLog(folder / "out");
  EXPECT_EQ(out.name, "dive");
  EXPECT_EQ(out.notes, "still");
  EXPECT_EQ(out.video, "");
  EXPECT_EQ(out.vehicle, "rov.yaml");
  EXPECT_EQ(Bytes(folder / "out/rov.yaml"), Bytes(folder / "rov.yaml"));
  const std::vector<std::string> again = {"--log=" + (folder / "out").string(),
                                          "--out=" + (folder / "again").string()};
  EXPECT_EQ(RunToolBinary("fathom_track", again).exit_code, 0);
  for (const std::string& more :
       {std::string("--from=images"), "--overlay=" + (folder / "a.png").string()}) {
    const std::vector<std::string> arguments = {
        "--log=" + (folder / "out").string(), "--out=" + (folder / "third").string(), more};
    EXPECT_EQ(ExpectRefusal("fathom_track", arguments, folder),
              "fathom_track: " + (folder / "out").string() +
                  ": holds no images: no frames.csv, and log.yaml names no video. See "
                  "docs/file_formats.md.\n");
  }
}

// The map of the new log is the one that its poses rest on.
TEST(TrackTool, WritesTheEstimatedMarkersAsThoseOfTheNewLog) {
  const fs::path log = CopyOfTheLog();
  const fs::path folder = log.parent_path();
  // A survey that is 0.1 m wrong in one tag.
  const MarkerMap truth = ReadTagsFile(log / "tags.yaml");
  MarkerMap survey = truth;
  ASSERT_EQ(survey.markers[1].id, 5);
  survey.markers[1].world_from_tag.translation.y() += 0.1;
  WriteTestFile(log / "tags.yaml", FormatTagsFile(survey));
  const fs::path out = folder / "out";
  const ToolRun run =
      Track(log, {"--out=" + out.string(), "--estimate_markers", "--reference=4", "--gate=100"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const MarkerMap found = ReadTagsFile(out / "tags.yaml");
  ASSERT_EQ(found.markers.size(), truth.markers.size());
  // Tag 4 holds the world; tag 5 beside it is found to centimetres from 2 to 4 m.
  EXPECT_EQ(found.Find(4)->world_from_tag.translation, truth.Find(4)->world_from_tag.translation);
  EXPECT_LT((found.Find(5)->world_from_tag.translation - truth.Find(5)->world_from_tag.translation)
                .norm(),
            0.03);
  EXPECT_FALSE(fs::exists(out / "tags_estimated.yaml"));
  // The same poses again, with the map as the survey.
  const ToolRun again = Track(out, {"--out=" + (folder / "again").string()});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  const CsvTable first = PosesIn(out);
  const CsvTable second = PosesIn(folder / "again");
  for (const char* axis : {"x", "y", "z"}) {
    for (std::size_t row = 0; row < 12; ++row) {
      EXPECT_NEAR((*second.stream.Find(axis))[row], (*first.stream.Find(axis))[row], 1e-3) << axis;
    }
  }
}

// Pixels of the sheet that are pure in one colour near a place of the image.
int NumColoured(const cv::Mat& sheet, const cv::Point& place, const cv::Vec3b& colour) {
  int num = 0;
  for (int v = place.y - 4; v <= place.y + 4; ++v) {
    for (int u = place.x - 4; u <= place.x + 4; ++u) {
      if (u < 0 || v < 0 || u >= sheet.cols || v >= sheet.rows) continue;
      if (cv::norm(cv::Vec3i(sheet.at<cv::Vec3b>(v, u)) - cv::Vec3i(colour)) < 30.0) ++num;
    }
  }
  return num;
}

// Green is in use, red is not: the corners of tag 5 in the first frame run the wrong way.
TEST(TrackTool, DrawsARejectedDetectionInRed) {
  const fs::path log = CopyOfTheLog();
  const fs::path folder = log.parent_path();
  ASSERT_EQ(Track(log, {"--overwrite"}).exit_code, 0);
  std::vector<Detection> detections = DetectionsOf(*ReadLog(log).detections);
  ASSERT_EQ(detections[1].tag_id, 5);
  std::reverse(detections[1].corners.begin(), detections[1].corners.end());
  WriteDetections(log / "detections.csv", detections);
  const ToolRun run = Track(
      log,
      {"--out=" + (folder / "tracked").string(), "--overlay=" + (folder / "sheet.png").string()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("Set aside as mirrored: 1 of 48 detections: tags 5 (1 time)."));
  const cv::Mat sheet = cv::imread((folder / "sheet.png").string());
  ASSERT_EQ(sheet.cols, 3 * 420);
  const cv::Vec3b green(80, 220, 60), red(60, 60, 255);
  const double scale = 420.0 / 800.0;
  // The dot at the first corner is filled: its pixels are of the pure colour.
  const auto dot = [&](int index) {
    const Eigen::Vector2d at = scale * (detections[index].corners[0] + Eigen::Vector2d(0.5, 0.5)) -
                               Eigen::Vector2d(0.5, 0.5);
    return cv::Point(static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y())));
  };
  EXPECT_GT(NumColoured(sheet, dot(1), red), 10);
  EXPECT_EQ(NumColoured(sheet, dot(1), green), 0);
  for (const int used : {0, 2}) {
    EXPECT_GT(NumColoured(sheet, dot(used), green), 10) << used;
    EXPECT_EQ(NumColoured(sheet, dot(used), red), 0) << used;
  }
}

// What cannot be written is refused before the work, and nothing is left of the rest.
TEST(TrackTool, LeavesNothingBehindWhereAnOutputCannotBeWritten) {
  const fs::path& log = RenderedLog();
  const fs::path folder = EmptyTestFolder();
  const std::vector<std::string> outputs = {"--log=" + log.string(),
                                            "--out=" + (folder / "deep/tracked").string(),
                                            "--overlay=" + (folder / "new/a.avi").string()};
  std::vector<std::string> arguments = outputs;
  arguments.emplace_back("--summary=/proc/x.json");
  EXPECT_THAT(ExpectRefusal("fathom_track", arguments, folder),
              StartsWith("fathom_track: /proc/x.json: cannot write this file: "));
  EXPECT_TRUE(ListOf(folder).empty());
  arguments.back() = "--summary=" + folder.string();
  EXPECT_EQ(ExpectRefusal("fathom_track", arguments, folder),
            "fathom_track: " + folder.string() + ": is a folder, expected a file to write.\n");
  EXPECT_TRUE(ListOf(folder).empty());
  arguments = {"--log=" + log.string(), "--out=/proc/tracked"};
  EXPECT_THAT(ExpectRefusal("fathom_track", arguments, folder),
              StartsWith("fathom_track: /proc/tracked: cannot write this file: "));
}

TEST(TrackTool, DoesNotReplaceALogThatHoldsImages) {
  const fs::path log = CopyOfTheLog();
  const fs::path folder = log.parent_path();
  const fs::path other = folder / "other";
  const auto refusal = [&] {
    return ExpectRefusal("fathom_track",
                         {"--log=" + log.string(), "--out=" + other.string(), "--overwrite"},
                         folder);
  };
  const auto holds = [&](const std::string& what) {
    return "fathom_track: --out=" + other.string() + ": the log in it holds " + what +
           ", which this program did not write and cannot make again, expected a new folder, or a "
           "log without images to replace. Remove that log yourself if it is not needed.\n";
  };
  WriteTestFile(other / "log.yaml", "name: other\ndof: surge\n");
  WriteTestFile(other / "frames/000.png", "an image");
  EXPECT_EQ(refusal(), holds("frames"));
  fs::remove_all(other / "frames");
  WriteTestFile(other / "dive.mp4", "a video");
  EXPECT_EQ(refusal(), holds("dive.mp4"));
  EXPECT_EQ(Bytes(other / "dive.mp4"), "a video");
  fs::remove(other / "dive.mp4");
  WriteTestFile(other / "frame_times.csv", "frame,t\n0,0\n1,1\n");
  EXPECT_EQ(refusal(), holds("frame_times.csv"));
  fs::remove(other / "frame_times.csv");
  const ToolRun run = Track(log, {"--out=" + other.string(), "--overwrite"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  // The log itself, by another way there.
  fs::create_directory_symlink(log, folder / "link");
  EXPECT_EQ(
      ExpectRefusal("fathom_track",
                    {"--log=" + log.string(), "--out=" + (folder / "link").string(), "--overwrite"},
                    folder),
      "fathom_track: --out: is --log itself. Leave it out to write into the log.\n");
}

// Whose name a program of Fathom would not have given it.
TEST(TrackTool, DoesNotReplaceALogThatHoldsSomebodysFiles) {
  const fs::path& log = RenderedLog();
  const fs::path folder = EmptyTestFolder();
  const fs::path other = folder / "other";
  WriteTestFile(other / "log.yaml", "name: other\ndof: surge\nvehicle: rov.yaml\n");
  WriteTestFile(other / "rov.yaml", "name: rov\nmass: 20\nsize: [1, 1, 1]\n");
  WriteTestFile(other / "survey.csv", "id,x\n1,2\n");
  EXPECT_THAT(ExpectRefusal("fathom_track",
                            {"--log=" + log.string(), "--out=" + other.string(), "--overwrite"},
                            folder),
              HasSubstr("the log in it holds survey.csv, which"));
  fs::remove(other / "survey.csv");
  const ToolRun run = Track(log, {"--out=" + other.string(), "--overwrite"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
}

TEST(TrackTool, KeepsOutputsOutOfTheFolderThatIsReplaced) {
  const fs::path& log = RenderedLog();
  const fs::path folder = EmptyTestFolder();
  const fs::path out = folder / "out";
  for (const std::string flag : {"--overlay", "--summary"}) {
    const std::string file = (out / "deep/../a.png").string();
    EXPECT_EQ(ExpectRefusal("fathom_track",
                            {"--log=" + log.string(), "--out=" + out.string(), flag + "=" + file},
                            folder),
              "fathom_track: " + flag + "=" + file + ": lies in --out=" + out.string() +
                  ", which is replaced as a whole, expected a file elsewhere.\n");
  }
}

TEST(TrackTool, DoesNotWriteOverWhatItReads) {
  const fs::path log = CopyOfTheLog();
  const fs::path image = log / "frames/000003.png";
  const std::string before = Bytes(image);
  for (const std::string flag : {"--overlay", "--summary"}) {
    EXPECT_EQ(ExpectRefusal("fathom_track",
                            {"--log=" + log.string(), "--overwrite", flag + "=" + image.string()},
                            log.parent_path()),
              "fathom_track: " + flag + "=" + image.string() + ": is what --log=" + log.string() +
                  " was filmed as, expected another file.\n");
  }
  EXPECT_EQ(Bytes(image), before);
}

// What somebody else detected stays as it is, to the byte and with its further columns.
TEST(TrackTool, LeavesTheDetectionsAloneThatItStartsFrom) {
  const fs::path log = CopyOfTheLog();
  const fs::path folder = log.parent_path();
  ASSERT_EQ(Track(log, {"--out=" + (folder / "first").string()}).exit_code, 0);
  std::istringstream rows(Bytes(folder / "first/detections.csv"));
  std::string with_margin;
  for (std::string row; std::getline(rows, row);) {
    with_margin += row + (with_margin.empty() ? ",margin\n" : ",0.123456789\n");
  }
  WriteTestFile(folder / "first/detections.csv", with_margin);
  ASSERT_EQ(Track(folder / "first", {"--out=" + (folder / "second").string()}).exit_code, 0);
  EXPECT_EQ(Bytes(folder / "second/detections.csv"), with_margin);
  ASSERT_EQ(Track(folder / "first", {"--overwrite"}).exit_code, 0);
  EXPECT_EQ(Bytes(folder / "first/detections.csv"), with_margin);
}

TEST(TrackTool, RefusesFlagsOfTheDetectionWhereThereIsNone) {
  const fs::path log = CopyOfTheLog();
  const fs::path folder = log.parent_path();
  ASSERT_EQ(Track(log, {"--out=" + (folder / "first").string()}).exit_code, 0);
  for (const std::string flag : {"max_hamming", "quad_decimate", "quad_sigma", "threads"}) {
    EXPECT_EQ(ExpectRefusal("fathom_track",
                            {"--log=" + (folder / "first").string(),
                             "--out=" + (folder / "second").string(),
                             "--" + flag + "=2"},
                            folder),
              "fathom_track: --" + flag + ": is about the detection, but the track starts from " +
                  (folder / "first/detections.csv").string() + ", expected --from=images too.\n");
  }
}

// Frames that are counted from 0 beside commands of the clock on the wall.
TEST(TrackTool, RefusesFramesOnAnotherClockThanTheCommands) {
  const fs::path log = CopyOfTheLog();
  const fs::path folder = log.parent_path();
  WriteTestFile(log / "command.csv", "t,tau_surge\n1700000000,1\n1700000001,2\n");
  fs::remove(log / "pose.csv");
  EXPECT_EQ(
      ExpectRefusal(
          "fathom_track", {"--log=" + log.string(), "--out=" + (folder / "out").string()}, folder),
      "fathom_track: " + (log / "command.csv").string() +
          ": column 't' runs from 1700000000 to 1700000001, but that of " +
          (log / "frames.csv").string() +
          " from 0 to 1.1, expected some time in common. Put both on one clock.\n");
}

TEST(TrackTool, SaysThatASinglePoseIsNoTrajectory) {
  const fs::path log = CopyOfTheLog();
  WriteTestFile(log / "frames.csv", "t,file\n0,frames/000000.png\n0.1,frames/black.png\n");
  cv::imwrite((log / "frames/black.png").string(), cv::Mat(600, 800, CV_8UC1, cv::Scalar(90)));
  const fs::path out = log.parent_path() / "tracked";
  const ToolRun run = Track(log, {"--out=" + out.string()});
  EXPECT_EQ(run.exit_code, 2) << run.err;
  EXPECT_THAT(run.err,
              HasSubstr("fathom_track: no usable trajectory: a single frame has a pose, expected "
                        "two at least.\n"));
  EXPECT_FALSE(fs::exists(out));
}

// The map of a track in place stands beside it, and goes with it.
TEST(TrackTool, ReplacesTheEstimateOfAnEarlierTrack) {
  const fs::path log = CopyOfTheLog();
  ASSERT_EQ(Track(log, {"--overwrite", "--estimate_markers"}).exit_code, 0);
  EXPECT_TRUE(fs::exists(log / "tags_estimated.yaml"));
  ASSERT_EQ(Track(log, {"--overwrite"}).exit_code, 0);
  EXPECT_FALSE(fs::exists(log / "tags_estimated.yaml"));
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
            "fathom_track: --max_hamming is 3, expected 0, 1 or 2.\n");
  for (const std::string threads : {"0", "257", "4294967295"}) {
    EXPECT_EQ(refusal(log, {out, "--threads=" + threads}),
              "fathom_track: --threads: is " + threads + ", expected 1 to 256.\n");
  }
  // As from an unset variable of a shell.
  EXPECT_EQ(refusal(log, {"--out=", "--overwrite"}),
            "fathom_track: --out: is empty, expected a folder. Leave it out to write into the "
            "log.\n");
  EXPECT_EQ(refusal(log, {out, "--reference=5"}),
            "fathom_track: --reference=5: stands without --estimate_markers, expected both: it is "
            "the marker that keeps its place while the others are estimated.\n");
  EXPECT_EQ(refusal(log, {out, "--estimate_markers", "--reference=-7"}),
            "fathom_track: --reference=-7: is no surveyed tag of " + (log / "tags.yaml").string() +
                ", expected one of 4, 5, 6, 9.\n");
  EXPECT_EQ(refusal(log, {out, "--gate=0"}),
            "fathom_track: --gate: is 0, expected a number above 0.\n");
  EXPECT_EQ(refusal(log, {out, "--overlay=" + (folder / "sheet.gif").string()}),
            "fathom_track: " + (folder / "sheet.gif").string() +
                ": expected a path that ends in .mp4 or .avi for a video, or in .png for a "
                "contact sheet.\n");
}

TEST(TrackTool, NamesAClockOffsetOfTheCameraThatIsNotApplied) {
  const fs::path log = CopyOfTheLog();
  WriteTestFile(log / "camera.yaml",
                "cam0: {camera_model: pinhole, distortion_model: radtan, resolution: [800, 600], "
                "intrinsics: [640, 641, 401.3, 297.6], timeshift_cam_imu: 0.1, "
                "distortion_coeffs: [-0.12, 0.03, 0.0006, -0.0004]}\n");
  const ToolRun run = Track(log, {"--overwrite"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("camera.yaml: timeshift_cam_imu is 0.1 s and not used: "));
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
