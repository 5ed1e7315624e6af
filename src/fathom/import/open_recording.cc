// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/open_recording.h"

#include "fathom/base/input_error.h"
#include "fathom/import/dataflash/dataflash_recording.h"
#include "fathom/import/matlab/mat4_file.h"
#include "fathom/import/matlab/mat5_file.h"
#include "fathom/import/matlab/mat73_file.h"
#include "fathom/import/matlab/matlab_recording.h"
#include "fathom/import/message/message_recording.h"
#include "fathom/import/moos/alog_recording.h"
#include "fathom/import/numpy/npy_header.h"
#include "fathom/import/numpy/numpy_recording.h"
#include "fathom/import/recording/byte_file.h"
#include "fathom/import/recording/decompress.h"
#include "fathom/import/recording/joined_recording.h"
#include "fathom/import/recording/unpacked_file.h"
#include "fathom/import/rock/pocolog_file.h"
#include "fathom/import/rock/typelib_definition.h"
#include "fathom/import/ros/mcap_file.h"
#include "fathom/import/ros/ros1_bag.h"
#include "fathom/import/ros/ros_definition.h"
#include "fathom/import/ros/rosbag2_database.h"
#include "fathom/import/table/table_recording.h"
#include "fathom/import/tlog/tlog_recording.h"
#include "fathom/import/ulog/ulog_recording.h"
#include "fathom/log/csv/refuse_utf16.h"
#include "fathom/log/log_content.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

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

std::unique_ptr<Recording> OpenFile(const std::filesystem::path& path,
                                    const TableOptions& table,
                                    bool takes_text,
                                    bool is_unpacked = false) {
  ByteFile file(path);
  const std::string first(file.View(0, kFirstBytes));
  if (LooksLikeDataflash(first)) return OpenDataflash(path);
  if (LooksLikeUlog(first)) return OpenUlog(path);
  if (LooksLikeMcap(first)) return OpenMessageRecording(path, OpenMcap(path), ParseRosDefinition);
  if (LooksLikeSqlite(first)) {
    return OpenMessageRecording(path, OpenRosbag2Database(path), ParseRosDefinition);
  }
  if (LooksLikeRos1Bag(first)) {
    return OpenMessageRecording(path, OpenRos1Bag(path), ParseRosDefinition);
  }
  if (LooksLikePocolog(first)) {
    return OpenMessageRecording(path, OpenPocolog(path), ParseTypelibDefinition);
  }
  if (LooksLikeTlog(first)) return OpenTlog(path);
  if (LooksLikeMat73(first)) return OpenMatlab(path, OpenMat73(path));
  if (LooksLikeMat5(first)) return OpenMatlab(path, OpenMat5(path));
  if (LooksLikeMat4(first)) return OpenMatlab(path, OpenMat4(path));
  if (LooksLikeNpy(first)) return OpenNpy(path);
  if (LooksLikeNpz(first)) return OpenNpz(path);
  if (LooksLikeAlog(first) || (path.extension() == ".alog" && LooksLikeText(first))) {
    return OpenAlog(path);
  }
  if (LooksLikeZstd(first) && !is_unpacked) {
    return OpenUnpacked(path, [&](const std::filesystem::path& unpacked) {
      return OpenFile(unpacked, table, /*takes_text=*/false, /*is_unpacked=*/true);
    });
  }
  if (takes_text && LooksLikeText(first)) return OpenTable(path, table);
  if (takes_text) RefuseUtf16(path.string(), first);
  throw InputError(
      fmt::format("{}: is {}, expected a table of text (CSV), an ArduPilot DataFlash log (.BIN), a "
                  "PX4 log (.ulg), a telemetry log (.tlog), a bag of ROS, a .mat of MATLAB, a "
                  ".npy or .npz of numpy, a log of Rock or an .alog of MOOS.",
                  path.string(),
                  first.empty() ? "empty" : "of no known format"));
}

bool IsCalledTable(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending == ".csv" || ending == ".txt" || ending == ".tsv" || ending == ".dat";
}

// By name. Throws InputError for a folder that cannot be read.
std::vector<std::filesystem::path> FilesIn(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (std::filesystem::directory_iterator at(folder, error), end; at != end; at.increment(error)) {
    if (error) break;
    std::error_code ignored;
    if (at->is_regular_file(ignored)) files.push_back(at->path());
  }
  if (error) {
    throw InputError(fmt::format("{}: cannot be read: {}.", folder.string(), error.message()));
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::unique_ptr<Recording> OpenFolder(const std::filesystem::path& folder,
                                      const TableOptions& table) {
  if (std::filesystem::exists(folder / "log.yaml")) {
    throw InputError(folder.string() +
                     ": is a log already, it has a log.yaml; expected a recording.");
  }
  std::vector<RecordingPart> parts;
  std::vector<std::string> remarks;
  for (const std::filesystem::path& file : FilesIn(folder)) {
    try {
      parts.push_back({file.filename().string(), OpenFile(file, table, IsCalledTable(file))});
    } catch (const InputError& error) {
      remarks.push_back(fmt::format("not read: {}", error.what()));
    }
  }
  return JoinRecordings(folder, std::move(parts), std::move(remarks));
}

bool HasKnownBegin(std::string_view first) {
  return LooksLikeDataflash(first) || LooksLikeMcap(first) || LooksLikeRos1Bag(first) ||
         LooksLikePocolog(first) || LooksLikeUlog(first) || LooksLikeTlog(first) ||
         LooksLikeMat73(first) || LooksLikeMat5(first) || LooksLikeMat4(first) ||
         LooksLikeNpy(first) || LooksLikeNpz(first) || LooksLikeAlog(first);
}

// Of a file that is compressed as a whole, as `ros2 bag record --compression-mode file` leaves it,
// the begin tells. It does not tell whose database it is: the name does.
bool IsCompressedRecording(const std::filesystem::path& file, std::string_view first) {
  std::string buffer;
  const std::string_view begin = Decompressed(Compression::kZstd, first, kFirstBytes, &buffer);
  return LooksLikeSqlite(begin) ? file.stem().extension() == ".db3" : HasKnownBegin(begin);
}

}  // namespace

std::unique_ptr<Recording> OpenRecording(const std::filesystem::path& path,
                                         const TableOptions& table) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return OpenFolder(path, table);
  return OpenFile(path, table, true);
}

bool IsRecording(const std::filesystem::path& file) {
  try {
    ByteFile bytes(file);
    const std::string first(bytes.View(0, kFirstBytes));
    // Of other databases there are many.
    if (LooksLikeSqlite(first)) return OpenRosbag2Database(file) != nullptr;
    return LooksLikeZstd(first) ? IsCompressedRecording(file, first) : HasKnownBegin(first);
  } catch (const InputError&) {
    return false;
  }
}

std::vector<std::filesystem::path> FilesOfRecording(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_directory(path, ignored) ? FilesIn(path) : std::vector{path};
}

std::string ContentOfRecording(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(path, ignored)) return ContentOf(path);
  std::vector<std::string> texts;
  for (const std::filesystem::path& file : FilesIn(path)) {
    texts.push_back(file.filename().string());
    texts.push_back(ContentOf(file));
  }
  return DigestOf(texts);
}

}  // namespace fathom
