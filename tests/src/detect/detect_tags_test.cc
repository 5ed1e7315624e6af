// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/detect/detect_tags.h"

#include "fathom/base/input_error.h"

#include <string>

#include "rendered_scene.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

// Three frames, none of which can be read.
class UnreadableFrames : public FrameSource {
 public:
  std::string name() const override { return "log/frames.csv"; }
  int num_expected() const override { return 3; }
  double mean_rate() const override { return 10.0; }
  bool Next(ImageFrame* /*frame*/) override {
    num_unreadable_ = 3;
    unreadable_ = {"log/frames.csv:2: a.png: there is no such file. Check the path."};
    return false;
  }
};

TEST(DetectTags, RefusesALogWithoutAFrameThatCanBeRead) {
  UnreadableFrames frames;
  EXPECT_THAT(
      [&] { DetectTags(frames, PlainCamera(), OneMarker("tag36h11", 7, 0.4), {}); },
      testing::ThrowsMessage<InputError>(
          "log/frames.csv: none of 3 frames can be read: log/frames.csv:2: a.png: there is no such "
          "file. Check the path."));
}

TEST(RemarksOnTagDetections, TellOfEverythingThatWasLost) {
  const MarkerMap map = OneMarker("tag36h11", 7, 0.4);
  TagDetections found;
  found.num_expected = 12;
  found.frame_times = {0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8};
  found.detections.resize(5);
  EXPECT_THAT(RemarksOn(found, map), testing::IsEmpty());
  found.num_unreadable = 3;
  found.num_not_followed = 2;
  found.times_without_tags = {0.1, 0.2, 0.3, 0.4};
  found.remarks = {"log/frame_times.csv: is not read."};
  EXPECT_THAT(RemarksOn(found, map),
              testing::ElementsAre("log/frame_times.csv: is not read.",
                                   "3 of 12 frames cannot be read.",
                                   "4 of 9 frames show no tag of tag36h11.",
                                   "2 of 5 detections keep the less accurate corners of "
                                   "libapriltag, because their sides could not be followed."));
}

}  // namespace
}  // namespace fathom
