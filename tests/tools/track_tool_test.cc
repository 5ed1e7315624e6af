// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// fathom_track from rendered images, whose trajectory is known, to poses.

#include "fathom/camera/tags_file.h"
#include "fathom/log/csv/csv_table.h"
#include "fathom/log/log.h"
#include "fathom/log/read_log.h"

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "expect_refusal.h"
#include "rendered_log.h"
#include "run_tool.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(TrackTool, FindsTheTrajectoryOfRenderedImages) {
  const fs::path& log = RenderedLog();
  const fs::path folder = EmptyTestFolder();
  const ToolRun run = RunsWell(Track(log,
                                     {Flag("out", folder / "tracked"),
                                      Flag("summary", folder / "track.json"),
                                      Flag("overlay", folder / "sheet.png")}));
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
  const auto summary = nlohmann::json::parse(TextOf(folder / "track.json"));
  EXPECT_EQ(summary["schema"], "fathom-track-1");
  EXPECT_EQ(summary["frames"]["expected"], 12);
  EXPECT_EQ(summary["frames"]["with_pose"], 12);
  EXPECT_EQ(summary["detections"]["found"], 48);
  EXPECT_EQ(summary["detections"]["sides_not_followed"], 0);
  EXPECT_LT(summary["fit"]["corner_sigma_px"], 0.15);
  EXPECT_GT(summary["fit"]["corner_sigma_px"], 0.01);
  EXPECT_THAT(TextOf(folder / "sheet.png"), StartsWith("\x89PNG"));
  for (const char* file : {"log.yaml", "command.csv", "camera.yaml", "tags.yaml", "mount.yaml"}) {
    EXPECT_EQ(TextOf(folder / "tracked" / file), TextOf(log / file)) << file;
  }

  // The same poses from the detections alone.
  const ToolRun again = RunsWell(Track(folder / "tracked", {Flag("out", folder / "again")}));
  const auto& first = *found.stream.Find("x");
  const CsvTable second_table = PosesIn(folder / "again");
  const auto& second = *second_table.stream.Find("x");
  // Detections are written to 1e-4 px: 1e-4 of the noise.
  for (std::size_t row = 0; row < first.size(); ++row) EXPECT_NEAR(second[row], first[row], 1e-5);
}

TEST(TrackTool, CountsDamagedImagesAndGoesOn) {
  const fs::path log = CopyOfTheLog();
  const fs::path image = log / "frames/000004.png";
  fs::resize_file(image, fs::file_size(image) / 3);
  fs::remove(log / "frames/000005.png");
  const fs::path out = log.parent_path() / "tracked";
  const fs::path summary = log.parent_path() / "track.json";
  const ToolRun run = RunsWell(Track(log, {Flag("out", out), Flag("summary", summary)}));
  EXPECT_THAT(run.err,
              HasSubstr((log / "frames.csv").string() + ":6: " + image.string() +
                        ": cannot decode this image: "));
  EXPECT_THAT(run.err, HasSubstr("frames/000005.png: there is no such file. Check the path.\n"));
  const auto json = nlohmann::json::parse(TextOf(summary));
  EXPECT_EQ(json["frames"]["expected"], 12);
  EXPECT_EQ(json["frames"]["unreadable"], 2);
  EXPECT_EQ(json["frames"]["with_pose"], 10);
  EXPECT_EQ(json["frames"]["unreadable_ones"].size(), 2u);
}

TEST(TrackTool, CountsTagsThatAreNotInTheMap) {
  const fs::path log = CopyOfTheLog();
  WriteTestFile(log / "tags.yaml", TextOf(kData + "/films/wall_one_tag.yaml"));
  const fs::path summary = log.parent_path() / "track.json";
  const ToolRun run =
      RunsWell(Track(log, {Flag("out", log.parent_path() / "tracked"), Flag("summary", summary)}));
  // Tags 5 and 6 in twelve frames; tag 9 is of a family that nobody looks for now.
  const auto unused = nlohmann::json::parse(TextOf(summary))["detections"]["sightings_not_used"];
  EXPECT_EQ(unused.size(), 24u);
  EXPECT_EQ(unused[0]["reason"], "is not in the map");
  EXPECT_THAT(run.out,
              HasSubstr("12 read, 0 unreadable, 0 without tags, 0 with unused tags only\n"));
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
  const ToolRun run =
      Track(log, {Flag("out", log.parent_path() / "tracked"), Flag("summary", summary)});
  EXPECT_EQ(run.exit_code, 2) << run.err;
  EXPECT_THAT(run.err, HasSubstr("12 of 12 frames show only tags that are not used"));
  EXPECT_THAT(run.err,
              HasSubstr("Not used: 36 sightings of a tag that is not in the map: tag36h11 4 (12 "
                        "times), tag36h11 5 (12 times), tag36h11 6 (12 times).\n"));
  EXPECT_THAT(run.err, Not(HasSubstr("no tag")));
  const auto frames = nlohmann::json::parse(TextOf(summary))["frames"];
  EXPECT_EQ(frames["without_tags"], 0);
  EXPECT_EQ(frames["times_with_unused_tags_only"].size(), 12u);
}

// A recording of the vehicle and a film beside it, on a clock of its own, become one log.
TEST(TrackTool, TracksTheVideoThatAnImportPutBesideARecording) {
  const fs::path folder = EmptyTestFolder();
  const fs::path& log = RenderedLog();
  RunsWell(Track(log, {Flag("out", folder / "first"), Flag("overlay", folder / "dive.avi")}));
  for (const char* file : {"camera.yaml", "tags.yaml", "mount.yaml"}) {
    fs::copy_file(log / file, folder / file);
  }
  fs::copy_file(log / "command.csv", folder / "vehicle.csv");
  WriteTestFile(folder / "map.yaml",
                "command: {tau_surge: {field: tau_surge, unit: N}}\ndof: surge\n"
                "camera: {video: dive.avi, start: 0.25}\n");
  const ToolRun imported = RunsWell("fathom_import",
                                    {Flag("from", folder / "vehicle.csv"),
                                     Flag("map", folder / "map.yaml"),
                                     Flag("out", folder / "log")});
  EXPECT_THAT(imported.out, HasSubstr("note: the motion is in the video. This tracks it: "));
  EXPECT_EQ(TextOf(folder / "log/dive.avi"), TextOf(folder / "dive.avi"));
  RunsWell("fathom_import",
           {Flag("from", folder / "vehicle.csv"),
            Flag("map", folder / "map.yaml"),
            Flag("out", folder / "log"),
            "--overwrite"});
  EXPECT_EQ(TextOf(folder / "log/dive.avi"), TextOf(folder / "dive.avi"));

  RunsWell(Track(folder / "log", {Flag("out", folder / "out")}));
  const CsvTable first = PosesIn(folder / "first"), again = PosesIn(folder / "out");
  ASSERT_EQ(again.stream.time.size(), first.stream.time.size());
  for (std::size_t row = 0; row < first.stream.time.size(); ++row) {
    const double since_the_first = first.stream.time[row] - first.stream.time.front();
    EXPECT_NEAR(again.stream.time[row], 0.25 + since_the_first, 1e-3);
    // The overlay lies on the markers.
    EXPECT_NEAR((*again.stream.Find("x"))[row], (*first.stream.Find("x"))[row], 0.05);
  }
  EXPECT_EQ(ReadLog(folder / "out").origin->file, "vehicle.csv");
}

// What is written is a log in itself: it names no video or vehicle that is not there.
TEST(TrackTool, WritesALogThatHoldsWhatItNames) {
  const fs::path log = CopyOfTheLog();
  const fs::path folder = log.parent_path();
  RunsWell(Track(log, {Flag("overlay", folder / "dive.avi"), "--overwrite"}));
  const fs::path dive = folder / "dive";
  for (const char* file : {"camera.yaml", "tags.yaml", "mount.yaml", "command.csv"}) {
    WriteTestFile(dive / file, TextOf(log / file));
  }
  fs::rename(folder / "dive.avi", dive / "dive.avi");
  std::string times = "frame,t\n";
  for (int i = 0; i < 12; ++i) times += fmt::format("{},{}\n", i, 0.1 * i);
  WriteTestFile(dive / "frame_times.csv", times);
  WriteTestFile(folder / "rov.yaml", "name: rov\nmass: 20\nsize: [1, 1, 1]\n");
  WriteTestFile(dive / "log.yaml",
                "name: dive\ndof: surge\nvideo: dive.avi\nvehicle: ../rov.yaml\nnotes: still\n"
                "mass: 21\ndive: harbour\n");

  RunsWell(Track(dive, {Flag("out", folder / "out")}));
  const Log out = ReadLog(folder / "out");
  EXPECT_EQ(out.name, "dive");
  EXPECT_EQ(out.notes, "still");
  EXPECT_EQ(out.mass, 21.0);
  EXPECT_EQ(out.dive, "harbour");
  EXPECT_EQ(out.video, "");
  EXPECT_EQ(out.vehicle, "rov.yaml");
  EXPECT_EQ(TextOf(folder / "out/rov.yaml"), TextOf(folder / "rov.yaml"));
  const std::vector<std::string> again = {Flag("log", folder / "out"),
                                          Flag("out", folder / "again")};
  RunsWell("fathom_track", again);
  const auto refusal_with = [&](const std::string& more) {
    return ExpectRefusal(
        "fathom_track", {Flag("log", folder / "out"), Flag("out", folder / "third"), more}, folder);
  };
  const std::string no_images =
      (folder / "out").string() +
      ": holds no images: no frames.csv, and log.yaml names no video. See "
      "docs/file_formats.md.";
  EXPECT_EQ(refusal_with("--from=images"), "fathom_track: " + no_images + "\n");
  // Detections are enough for poses, but not for an overlay.
  const std::string overlay = Flag("overlay", folder / "a.png");
  EXPECT_EQ(refusal_with(overlay),
            "fathom_track: " + overlay +
                ": is drawn on the images that the detections are of, and they cannot be opened. " +
                no_images + " Leave out --overlay: the poses do without it.\n");
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
  RunsWell(Track(log, {Flag("out", out), "--estimate_markers", "--reference=4", "--gate=100"}));
  const MarkerMap found = ReadTagsFile(out / "tags.yaml");
  ASSERT_EQ(found.markers.size(), truth.markers.size());
  // Tag 4 holds the world; tag 5 beside it is found to centimetres from 2 to 4 m.
  EXPECT_EQ(found.Find(4)->world_from_tag.translation, truth.Find(4)->world_from_tag.translation);
  EXPECT_LT((found.Find(5)->world_from_tag.translation - truth.Find(5)->world_from_tag.translation)
                .norm(),
            0.03);
  EXPECT_FALSE(fs::exists(out / "tags_estimated.yaml"));
  // The same poses again, with the map as the survey.
  const ToolRun again = RunsWell(Track(out, {Flag("out", folder / "again")}));
  const CsvTable first = PosesIn(out);
  const CsvTable second = PosesIn(folder / "again");
  for (const char* axis : {"x", "y", "z"}) {
    for (std::size_t row = 0; row < 12; ++row) {
      EXPECT_NEAR((*second.stream.Find(axis))[row], (*first.stream.Find(axis))[row], 1e-3) << axis;
    }
  }
}

}  // namespace
}  // namespace fathom
