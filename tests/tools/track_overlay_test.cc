// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// What fathom_track draws on the frames.

#include "fathom/camera/detections_file.h"
#include "fathom/log/read_log.h"

#include <cmath>
#include <cstddef>
#include <filesystem>
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

TEST(TrackTool, WritesAnOverlayVideo) {
  const fs::path folder = EmptyTestFolder();
  RunsWell(Track(RenderedLog(),
                 {Flag("out", folder / "tracked"), Flag("overlay", folder / "overlay.avi")}));
  EXPECT_THAT(TextOf(folder / "overlay.avi"), StartsWith("RIFF"));
  EXPECT_EQ(ListOf(folder).size(), ListOf(folder / "tracked").size() + 2);
}

TEST(TrackTool, SaysWhatIsMissingInAnOverlayOfDetections) {
  const fs::path log = CopyOfTheLog();
  const fs::path tracked = log.parent_path() / "tracked";
  RunsWell(Track(log, {Flag("out", tracked)}));
  // The fourth row, of the first frame's last tag, a little later; and a frame that is not there.
  std::string csv = TextOf(tracked / "detections.csv");
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
                  Flag("out", again),
                  Flag("overlay", log.parent_path() / file)});
  };
  const ToolRun run = RunsWell(overlay("overlay.avi"));
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
  RunsWell(Track(log, {"--overwrite"}));
  std::vector<Detection> detections = DetectionsOf(*ReadLog(log).detections);
  ASSERT_EQ(detections[1].tag_id, 5);
  std::reverse(detections[1].corners.begin(), detections[1].corners.end());
  WriteDetections(log / "detections.csv", detections);
  const ToolRun run = RunsWell(
      Track(log, {Flag("out", folder / "tracked"), Flag("overlay", folder / "sheet.png")}));
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

}  // namespace
}  // namespace fathom
