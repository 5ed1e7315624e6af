// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/images/frame_list.h"

#include <string>

#include "error_from.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

std::string RefusalOfList(const std::string& text) {
  return ErrorFrom([&] { ParseFrameList("log/frames.csv", text); });
}

std::string RefusalOfTimes(const std::string& text) {
  return ErrorFrom([&] { ParseFrameTimes("log/frame_times.csv", text); });
}

TEST(ParseFrameList, ReadsStampsAndFiles) {
  const auto [frames, remark] =
      ParseFrameList("frames.csv", "camera,file,t\n0,a 1.png,1.5\n0,\"sub/b.png\",2.25\n");
  EXPECT_EQ(remark, "frames.csv: 1 further column is not read: camera.");
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[0].time, 1.5);
  EXPECT_EQ(frames[0].file, "a 1.png");
  EXPECT_EQ(frames[1].file, "sub/b.png");
  EXPECT_EQ(frames[1].line, 3);
}

TEST(ParseFrameList, RefusesWhatBreaksTheFormat) {
  EXPECT_EQ(RefusalOfList("t,image\n0,a.png\n1,b.png\n"),
            "log/frames.csv:1: column 'file' is missing, found t, image; expected t, file.");
  EXPECT_EQ(RefusalOfList("t,file\n0,a.png\n1,\n"),
            "log/frames.csv:3: column 'file' is empty, expected the path of an image from this "
            "folder on.");
  EXPECT_EQ(RefusalOfList("t,file\n0,../a.png\n1,b.png\n"),
            "log/frames.csv:2: column 'file' is '../a.png', expected the path of an image from "
            "this folder on.");
  EXPECT_EQ(RefusalOfList("t,file\n0,/a.png\n1,b.png\n"),
            "log/frames.csv:2: column 'file' is '/a.png', expected the path of an image from this "
            "folder on.");
  EXPECT_EQ(RefusalOfList("t,file\n0,a.png\n1,a.png\n"),
            "log/frames.csv:3: column 'file' is 'a.png' as on line 2, expected each image once.");
  EXPECT_EQ(RefusalOfList("t,file\n0,sub/a.png\n1,./sub//a.png\n"),
            "log/frames.csv:3: column 'file' is './sub//a.png' as on line 2, expected each image "
            "once.");
  EXPECT_EQ(RefusalOfList("t,file\n1,a.png\n0,b.png\n"),
            "log/frames.csv:3: column 't' goes back from 1 to 0, expected rising stamps. Sort the "
            "rows, or split the log where its clock was reset.");
  EXPECT_EQ(RefusalOfList("t,file\nx,a.png\n0,b.png\n"),
            "log/frames.csv:2: column 't' is 'x', expected a number such as -0.25. Remove the row "
            "or repair it upstream; this reader does not guess.");
}

TEST(ParseFrameTimes, ReadsOneStampForEachFrame) {
  const auto [times, remark] = ParseFrameTimes("frame_times.csv", "frame,t\n0,0.5\n1,0.6\n2,0.7\n");
  EXPECT_EQ(remark, "");
  EXPECT_EQ(times, (std::vector<double>{0.5, 0.6, 0.7}));
}

TEST(ParseFrameTimes, NamesTheColumnsThatItDoesNotRead) {
  EXPECT_EQ(ParseFrameTimes("frame_times.csv", "frame,t,gain\n0,0.5,1\n1,0.6,1\n").remark,
            "frame_times.csv: 1 further column is not read: gain.");
}

TEST(ParseFrameTimes, RefusesAGap) {
  EXPECT_EQ(RefusalOfTimes("frame,t\n0,0.5\n2,0.7\n"),
            "log/frame_times.csv:3: column 'frame' is 2, expected 1: the frames of the video in "
            "order, from 0 on.");
}

}  // namespace
}  // namespace fathom
