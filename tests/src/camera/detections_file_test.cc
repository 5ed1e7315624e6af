// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/camera/detections_file.h"

#include <vector>

#include "test_folder.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(DetectionsFile, ReadsBackWhatItWrites) {
  std::vector<Detection> detections(3);
  for (int row = 0; row < 3; ++row) {
    detections[row].time = 1433350623.677131 + 0.1 * (row / 2);
    detections[row].tag_id = 7 - row;
    for (int i = 0; i < 4; ++i) {
      detections[row].corners[i] = {100.0 * row + 10.0 * i + 0.123456, -3.0 * i - 0.5};
    }
  }
  const auto path = TestFolder() / "detections.csv";
  WriteDetections(path, detections);
  const std::vector<Detection> again = ReadDetections(path);
  ASSERT_EQ(again.size(), 3u);
  for (int row = 0; row < 3; ++row) {
    EXPECT_EQ(again[row].time, detections[row].time);
    EXPECT_EQ(again[row].tag_id, detections[row].tag_id);
    for (int i = 0; i < 4; ++i) {
      // Rounded to 1e-4 px.
      EXPECT_LE((again[row].corners[i] - detections[row].corners[i]).lpNorm<Eigen::Infinity>(),
                0.5001e-4);
    }
  }
}

}  // namespace
}  // namespace fathom
