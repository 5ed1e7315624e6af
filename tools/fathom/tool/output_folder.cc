// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/output_folder.h"

#include "fathom/base/input_error.h"
#include "fathom/log/log_files.h"

#include <algorithm>
#include <set>
#include <system_error>

#include <fmt/format.h>

namespace fathom {
namespace {

// Whether the renderer has named everything in a folder `frames`.
bool HoldsRenderedFramesOnly(const std::filesystem::path& frames) {
  for (const auto& entry : std::filesystem::directory_iterator(frames)) {
    const std::string stem = entry.path().stem().string();
    const bool is_number = stem.find_first_not_of("0123456789") == std::string::npos;
    if (!is_number || entry.path().extension() != ".png") return false;
  }
  return true;
}

// What a folder holds that no program of Fathom has written; empty if there is nothing.
std::string ForeignFileIn(const std::filesystem::path& folder, const std::string& images) {
  std::set<std::string> written = FilesOfLog(folder);
  if (images != "frames") written.erase("frames.csv");
  written.insert(images);
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_directory()) {
      if (name == "frames" && name == images && HoldsRenderedFramesOnly(entry.path())) continue;
      return name;
    }
    if (!written.contains(name)) return name;
  }
  return "";
}

}  // namespace

std::filesystem::path OutputFolder(const std::string& out,
                                   bool overwrite,
                                   const std::string& images) {
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
  if (const std::string foreign = ForeignFileIn(named, images); !foreign.empty()) {
    throw InputError(
        fmt::format("--out={}: the log in it holds {}, which this program did not write and cannot "
                    "make again, expected a new folder, or a log without images to replace. Remove "
                    "that log yourself if it is not needed.",
                    out,
                    foreign));
  }
  return named;
}

void RequireOutside(const std::filesystem::path& folder,
                    std::string_view flag,
                    const std::string& file) {
  if (file.empty()) return;
  const auto inner = std::filesystem::weakly_canonical(file);
  const auto outer = std::filesystem::weakly_canonical(folder);
  const auto [outer_end, inner_end] =
      std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end());
  if (outer_end != outer.end()) return;
  throw InputError(
      fmt::format("--{}={}: lies in --out={}, which is replaced as a whole, expected a file "
                  "elsewhere.",
                  flag,
                  file,
                  folder.string()));
}

}  // namespace fathom
