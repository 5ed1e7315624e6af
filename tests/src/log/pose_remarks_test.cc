// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/log/pose_remarks.h"

#include "fathom/base/input_error.h"
#include "fathom/log/read_log.h"

#include <string>
#include <vector>

#include "error_from.h"
#include "log_folder.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(ReadLog, RepeatsWhatIsToBeSaidOfThePoses) {
  const std::vector<Remark> remarks = {{RemarkKind::kPoses, "2 poses: \"bad\", say."},
                                       {RemarkKind::kLostMotion, "line\nbreak # [x]"}};
  const std::string yaml = FormatPoseRemarks(remarks, 2);
  EXPECT_EQ(ParsePoseRemarks("pose.yaml", yaml, 2), remarks);
  const Log log = ReadLog(FolderWith({{"pose.csv", kReadPose}, {"pose.yaml", yaml}}));
  EXPECT_THAT(TextsOf(log.remarks),
              ElementsAre("pose.yaml: " + remarks[0].text, "pose.yaml: " + remarks[1].text));
  EXPECT_EQ(log.remarks[1].kind, RemarkKind::kLostMotion);
  // Without poses there is nothing to say.
  EXPECT_THAT(ReadLog(FolderWith({{"pose.yaml", yaml}})).remarks, IsEmpty());
  EXPECT_THROW(ParsePoseRemarks("pose.yaml", yaml, 3), InputError);
}

TEST(ReadLog, ReadsThePlainSentencesOnPosesOfBefore) {
  const std::string lost =
      "2 poses rest on a single marker whose tilt they know to 0.06 rad: noise of the tilt";
  EXPECT_THAT(ParsePoseRemarks("pose.yaml", "poses: 2\nremarks: [a, '" + lost + "']\n", 2),
              ElementsAre(Remark{RemarkKind::kPoses, "a"}, Remark{RemarkKind::kLostMotion, lost}));
  EXPECT_THAT(ParsePoseRemarks("pose.yaml", "poses: 2\nremarks: []\n", 2), IsEmpty());
}

TEST(ReadLog, RefusesARemarkOfAnUnknownKind) {
  const std::string yaml = "poses: 2\nremarks: [{kind: loud, text: a}]\n";
  EXPECT_EQ(ErrorFrom([&] { ParsePoseRemarks("pose.yaml", yaml, 2); }),
            "pose.yaml:2: key 'remarks[0].kind' is 'loud', expected poses or lost_motion.");
}

}  // namespace
}  // namespace fathom
