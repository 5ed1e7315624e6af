// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tools/output_folder.h"

#include "fathom/base/input_error.h"

#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

namespace fathom {
namespace {

// What of a log is not plain text that a tool has written; empty if there is nothing.
std::string RawDataIn(const std::filesystem::path& folder, bool makes_images) {
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::filesystem::path name = entry.path().filename();
    if (makes_images && (name == "frames" || name == "frames.csv")) continue;
    const bool is_text = name.extension() == ".csv" || name.extension() == ".yaml";
    if (!is_text || entry.is_directory() || name == "frames.csv" || name == "frame_times.csv") {
      return name.string();
    }
  }
  return "";
}

}  // namespace

std::filesystem::path OutputFolder(const std::string& out, bool overwrite, bool makes_images) {
  const std::filesystem::path folder = out;
  // Without a slash at the end, which would make the temporary's place be inside it.
  const std::filesystem::path named = folder.has_filename() ? folder : folder.parent_path();
  std::error_code error;
  if (!std::filesystem::exists(named, error)) return named;
  if (!std::filesystem::is_directory(named, error)) {
    throw InputError(fmt::format("--out={}: is a file, expected a folder.", out));
  }
  if (std::filesystem::is_empty(named, error) && !error) return named;
  // Only what is a log may be replaced: a wrong path must not cost a folder of something else.
  const bool is_log = std::filesystem::exists(named / "log.yaml", error);
  if (!overwrite || !is_log) {
    throw InputError(fmt::format("--out={}: the folder is not empty{}.",
                                 out,
                                 is_log ? ", expected --overwrite to replace the log in it"
                                        : " and holds no log, expected a new folder"));
  }
  if (const std::string raw = RawDataIn(named, makes_images); !raw.empty()) {
    throw InputError(
        fmt::format("--out={}: the log in it holds {}, which this program did not write and cannot "
                    "make again, expected a new folder, or a log without images to replace. Remove "
                    "that log yourself if it is not needed.",
                    out,
                    raw));
  }
  return named;
}

FolderInTheMaking::FolderInTheMaking(const std::filesystem::path& folder)
    : folder_(folder), temporary_(folder.string() + ".part" + std::to_string(getpid())) {}

FolderInTheMaking::~FolderInTheMaking() {
  std::error_code error;
  std::filesystem::remove_all(temporary_, error);
}

void FolderInTheMaking::Finish() const {
  std::error_code error;
  std::filesystem::remove_all(folder_, error);
  if (!error) std::filesystem::rename(temporary_, folder_, error);
  if (error) {
    throw InputError(
        fmt::format("{}: cannot write this folder: {}.", folder_.string(), error.message()));
  }
}

}  // namespace fathom
