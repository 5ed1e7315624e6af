// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

namespace fathom {

// One row of frames.csv.
struct ListedFrame {
  double time = 0.0;  // log time [s]
  std::string file;   // as written, a path from the log's folder
  int line = 0;       // counted from 1
};

struct FrameList {
  std::vector<ListedFrame> frames;  // in the order of their stamps
  std::string remark;               // CsvTable::Remark()
};

// The images of a log; `name` stands for the file in messages. Throws InputError, naming file, line
// and column, for whatever breaks the format of a CSV file, a path that leaves the log's folder and
// an image that stands twice.
FrameList ParseFrameList(const std::string& name, const std::string& text);

struct FrameTimes {
  std::vector<double> times;  // log time of each frame of a video, by its number from 0 on [s]
  std::string remark;         // CsvTable::Remark()
};

// frame_times.csv. Throws as above, and where a frame is left out.
FrameTimes ParseFrameTimes(const std::string& name, const std::string& text);

}  // namespace fathom
