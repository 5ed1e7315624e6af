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

// The images of a log, in the order of their stamps; `name` stands for the file in messages. Throws
// InputError, naming file, line and column, for whatever breaks the format of a CSV file, a path
// that leaves the log's folder and an image that stands twice.
std::vector<ListedFrame> ParseFrameList(const std::string& name, const std::string& text);

// frame_times.csv: when each frame of a video was taken, log time [s], by its number from 0 on.
// Throws as above, and where a frame is left out.
std::vector<double> ParseFrameTimes(const std::string& name, const std::string& text);

}  // namespace fathom
