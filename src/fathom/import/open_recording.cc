// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/open_recording.h"

#include "fathom/base/input_error.h"
#include "fathom/import/dataflash/dataflash_recording.h"
#include "fathom/import/matlab/mat4_file.h"
#include "fathom/import/matlab/mat5_file.h"
#include "fathom/import/matlab/mat73_file.h"
#include "fathom/import/matlab/matlab_recording.h"
#include "fathom/import/recording/byte_file.h"
#include "fathom/import/ros/mcap_file.h"
#include "fathom/import/ros/ros1_bag.h"
#include "fathom/import/ros/ros_recording.h"
#include "fathom/import/ros/rosbag2_database.h"
#include "fathom/import/table/table_recording.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::size_t kFirstBytes = 4096;

// Text holds no control characters but those of lines and tabs.
bool LooksLikeText(std::string_view bytes) {
  return !bytes.empty() && std::none_of(bytes.begin(), bytes.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 32 && c != '\n' && c != '\r' && c != '\t';
  });
}

}  // namespace

std::unique_ptr<Recording> OpenRecording(const std::filesystem::path& path,
                                         const TableOptions& table) {
  ByteFile file(path);
  const std::string first(file.View(0, kFirstBytes));
  if (LooksLikeDataflash(first)) return OpenDataflash(path);
  if (LooksLikeMcap(first)) return OpenRosRecording(path, OpenMcap(path));
  if (LooksLikeSqlite(first)) return OpenRosRecording(path, OpenRosbag2Database(path));
  if (LooksLikeRos1Bag(first)) return OpenRosRecording(path, OpenRos1Bag(path));
  if (LooksLikeMat73(first)) return OpenMatlab(path, OpenMat73(path));
  if (LooksLikeMat5(first)) return OpenMatlab(path, OpenMat5(path));
  if (LooksLikeMat4(first)) return OpenMatlab(path, OpenMat4(path));
  if (LooksLikeText(first)) return OpenTable(path, table);
  throw InputError(
      fmt::format("{}: is {}, expected a table of text (CSV), an ArduPilot DataFlash log (.BIN), "
                  "a bag of ROS or a .mat of MATLAB.",
                  path.string(),
                  first.empty() ? "empty" : "of no known format"));
}

}  // namespace fathom
