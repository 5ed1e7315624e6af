// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// What fathom_track does not write over, and what it refuses.

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "expect_refusal.h"
#include "rendered_log.h"
#include "run_tool.h"
#include <gmock/gmock.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

namespace fathom {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

// What cannot be written is refused before the work, and nothing is left of the rest.
TEST(TrackTool, LeavesNothingBehindWhereAnOutputCannotBeWritten) {
  const fs::path& log = RenderedLog();
  const fs::path folder = EmptyTestFolder();
  const std::vector<std::string> outputs = {Flag("log", log),
                                            Flag("out", folder / "deep/tracked"),
                                            Flag("overlay", folder / "new/a.avi")};
  std::vector<std::string> arguments = outputs;
  arguments.emplace_back("--summary=/proc/x.json");
  EXPECT_THAT(ExpectRefusal("fathom_track", arguments, folder),
              StartsWith("fathom_track: /proc/x.json: cannot write this file: "));
  EXPECT_TRUE(ListOf(folder).empty());
  arguments.back() = Flag("summary", folder);
  EXPECT_EQ(ExpectRefusal("fathom_track", arguments, folder),
            "fathom_track: " + folder.string() + ": is a folder, expected a file to write.\n");
  EXPECT_TRUE(ListOf(folder).empty());
  arguments = {Flag("log", log), "--out=/proc/tracked"};
  EXPECT_THAT(ExpectRefusal("fathom_track", arguments, folder),
              StartsWith("fathom_track: /proc/tracked: cannot write this file: "));
}

TEST(TrackTool, DoesNotReplaceALogThatHoldsImages) {
  const fs::path log = CopyOfTheLog();
  const fs::path folder = log.parent_path();
  const fs::path other = folder / "other";
  const auto refusal = [&] {
    return ExpectRefusal(
        "fathom_track", {Flag("log", log), Flag("out", other), "--overwrite"}, folder);
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
  EXPECT_EQ(TextOf(other / "dive.mp4"), "a video");
  fs::remove(other / "dive.mp4");
  WriteTestFile(other / "frame_times.csv", "frame,t\n0,0\n1,1\n");
  EXPECT_EQ(refusal(), holds("frame_times.csv"));
  fs::remove(other / "frame_times.csv");
  RunsWell(Track(log, {Flag("out", other), "--overwrite"}));
  // The log itself, by another way there.
  fs::create_directory_symlink(log, folder / "link");
  EXPECT_EQ(
      ExpectRefusal(
          "fathom_track", {Flag("log", log), Flag("out", folder / "link"), "--overwrite"}, folder),
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
  EXPECT_THAT(
      ExpectRefusal("fathom_track", {Flag("log", log), Flag("out", other), "--overwrite"}, folder),
      HasSubstr("the log in it holds survey.csv, which"));
  fs::remove(other / "survey.csv");
  RunsWell(Track(log, {Flag("out", other), "--overwrite"}));
}

TEST(TrackTool, KeepsOutputsOutOfTheFolderThatIsReplaced) {
  const fs::path& log = RenderedLog();
  const fs::path folder = EmptyTestFolder();
  const fs::path out = folder / "out";
  for (const std::string flag : {"--overlay", "--summary"}) {
    const std::string file = (out / "deep/../a.png").string();
    EXPECT_EQ(ExpectRefusal(
                  "fathom_track", {Flag("log", log), Flag("out", out), flag + "=" + file}, folder),
              "fathom_track: " + flag + "=" + file + ": lies in --out=" + out.string() +
                  ", which is replaced as a whole, expected a file elsewhere.\n");
  }
}

TEST(TrackTool, DoesNotWriteOverWhatItReads) {
  const fs::path log = CopyOfTheLog();
  const fs::path image = log / "frames/000003.png";
  const std::string before = TextOf(image);
  for (const std::string flag : {"--overlay", "--summary"}) {
    EXPECT_EQ(ExpectRefusal("fathom_track",
                            {Flag("log", log), "--overwrite", flag + "=" + image.string()},
                            log.parent_path()),
              "fathom_track: " + flag + "=" + image.string() + ": is what --log=" + log.string() +
                  " was filmed as, expected another file.\n");
  }
  EXPECT_EQ(TextOf(image), before);
}

// What somebody else detected stays as it is, to the byte and with its further columns.
TEST(TrackTool, LeavesTheDetectionsAloneThatItStartsFrom) {
  const fs::path log = CopyOfTheLog();
  const fs::path folder = log.parent_path();
  RunsWell(Track(log, {Flag("out", folder / "first")}));
  std::istringstream rows(TextOf(folder / "first/detections.csv"));
  std::string with_margin;
  for (std::string row; std::getline(rows, row);) {
    with_margin += row + (with_margin.empty() ? ",margin\n" : ",0.123456789\n");
  }
  WriteTestFile(folder / "first/detections.csv", with_margin);
  RunsWell(Track(folder / "first", {Flag("out", folder / "second")}));
  EXPECT_EQ(TextOf(folder / "second/detections.csv"), with_margin);
  RunsWell(Track(folder / "first", {"--overwrite"}));
  EXPECT_EQ(TextOf(folder / "first/detections.csv"), with_margin);
}

TEST(TrackTool, RefusesFlagsOfTheDetectionWhereThereIsNone) {
  const fs::path log = CopyOfTheLog();
  const fs::path folder = log.parent_path();
  RunsWell(Track(log, {Flag("out", folder / "first")}));
  for (const std::string flag : {"max_hamming", "quad_decimate", "quad_sigma", "threads"}) {
    EXPECT_EQ(
        ExpectRefusal(
            "fathom_track",
            {Flag("log", folder / "first"), Flag("out", folder / "second"), "--" + flag + "=2"},
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
  EXPECT_EQ(ExpectRefusal("fathom_track", {Flag("log", log), Flag("out", folder / "out")}, folder),
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
  const ToolRun run = Track(log, {Flag("out", out)});
  EXPECT_EQ(run.exit_code, 2) << run.err;
  EXPECT_THAT(run.err,
              HasSubstr("fathom_track: no usable trajectory: a single frame has a pose, expected "
                        "two at least.\n"));
  EXPECT_FALSE(fs::exists(out));
}

// The map of a track in place stands beside it, and goes with it.
TEST(TrackTool, ReplacesTheEstimateOfAnEarlierTrack) {
  const fs::path log = CopyOfTheLog();
  RunsWell(Track(log, {"--overwrite", "--estimate_markers"}));
  EXPECT_TRUE(fs::exists(log / "tags_estimated.yaml"));
  RunsWell(Track(log, {"--overwrite"}));
  EXPECT_FALSE(fs::exists(log / "tags_estimated.yaml"));
}

TEST(TrackTool, RefusesWhatItCannotUse) {
  const fs::path log = CopyOfTheLog();
  const fs::path folder = log.parent_path();
  const std::string out = Flag("out", folder / "tracked");
  const auto refusal = [&](const fs::path& path, std::vector<std::string> more) {
    more.push_back(Flag("log", path));
    return ExpectRefusal("fathom_track", more, folder);
  };
  EXPECT_EQ(
      refusal(log, {}),
      "fathom_track: " + (log / "pose.csv").string() +
          ": is there already, expected --overwrite to replace it, or --out for a new log.\n");
  EXPECT_EQ(refusal(folder / "nowhere", {out}),
            "fathom_track: " + (folder / "nowhere").string() +
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
  EXPECT_EQ(refusal(log, {out, Flag("overlay", folder / "sheet.gif")}),
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
  const ToolRun run = RunsWell(Track(log, {"--overwrite"}));
  EXPECT_THAT(run.err, HasSubstr("camera.yaml: timeshift_cam_imu is 0.1 s and not used: "));
}

TEST(TrackTool, RefusesALogWithoutCalibrationOrWithAnothers) {
  const fs::path log = CopyOfTheLog();
  const fs::path folder = log.parent_path();
  const std::vector<std::string> arguments = {Flag("log", log), Flag("out", folder / "tracked")};
  const std::string camera = TextOf(log / "camera.yaml");
  std::string half = camera;
  half.replace(half.find("image_width: 800"), 16, "image_width: 700");
  WriteTestFile(log / "camera.yaml", half);
  EXPECT_THAT(ExpectRefusal("fathom_track", arguments, folder),
              HasSubstr((log / "frames/000000.png").string() +
                        ": is 800 x 600 pixels, expected 700 x 600 as in " +
                        (log / "camera.yaml").string()));
  for (const char* file : {"camera.yaml", "tags.yaml", "mount.yaml"}) {
    const std::string text = file == std::string("camera.yaml") ? camera : TextOf(log / file);
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

TEST(TrackTool, NamesAllMissingFilesAtOnce) {
  const fs::path folder = EmptyTestFolder();
  const fs::path log = folder / "log";
  WriteTestFile(log / "mount.yaml", "never read\n");
  const auto refusal = [&] {
    return ExpectRefusal("fathom_track", {Flag("log", log), Flag("out", folder / "out")}, folder);
  };
  const std::string rig =
      "no camera.yaml (the camera's calibration), no tags.yaml (size and place of the markers), ";
  EXPECT_THAT(refusal(),
              HasSubstr(rig + "no log.yaml (name and dof of the log), no images (frames.csv, or a "
                              "video that log.yaml's key 'video' names), expected them"));
  WriteTestFile(log / "log.yaml", "name: dive\ndof: surge\nvideo: dive.mp4\n");
  EXPECT_THAT(refusal(),
              HasSubstr(rig + "no dive.mp4 (the video, as log.yaml's key 'video' says), expected"));
}

TEST(TrackTool, SaysWhenNothingIsSeen) {
  const fs::path log = CopyOfTheLog();
  WriteTestFile(log / "tags.yaml",
                "family: tag25h9\ntags: [{id: 1, size: 0.4, world_from_tag: {position: [4, 0, 0], "
                "quaternion: [0.5, 0.5, 0.5, 0.5]}}]\n");
  const fs::path out = log.parent_path() / "tracked";
  const ToolRun run = Track(log, {Flag("out", out)});
  EXPECT_EQ(run.exit_code, 2) << run.err;
  EXPECT_THAT(run.err, HasSubstr("fathom_track: no usable trajectory: "));
  EXPECT_FALSE(fs::exists(out));
}

}  // namespace
}  // namespace fathom
