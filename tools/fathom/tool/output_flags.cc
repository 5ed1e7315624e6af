// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/output_flags.h"

#include "fathom/base/files/output_file.h"
#include "fathom/base/input_error.h"
#include "fathom/log/log_files.h"

#include <filesystem>
#include <system_error>

#include <fmt/format.h>

namespace fathom {
namespace {

namespace fs = std::filesystem;

bool IsSamePlace(const fs::path& a, const fs::path& b) {
  std::error_code error;
  const fs::path place = fs::weakly_canonical(a, error);
  // What cannot hold a file's content, as /dev/null, loses none.
  if (fs::exists(place, error) && fs::is_other(place, error)) return false;
  return place == fs::weakly_canonical(b, error);
}

void RequireOtherThan(const std::string& input, const OutputFlag& output) {
  std::error_code error;
  if (!fs::is_directory(input, error)) {
    if (!IsSamePlace(output.file, input)) return;
    throw InputError(fmt::format(
        "--{}={}: is read by this program, expected another file.", output.name, output.file));
  }
  for (const std::string& file : FilesOfLog(input)) {
    if (!IsSamePlace(output.file, fs::path(input) / file)) continue;
    throw InputError(fmt::format("--{}={}: is {} of the log {}, expected another file.",
                                 output.name,
                                 output.file,
                                 file,
                                 input));
  }
}

}  // namespace

void RequireOutputs(const std::vector<OutputFlag>& outputs,
                    const std::vector<std::string>& inputs) {
  for (const OutputFlag& output : outputs) {
    if (output.file.empty()) continue;
    for (const std::string& input : inputs) {
      if (!input.empty()) RequireOtherThan(input, output);
    }
    for (const OutputFlag& other : outputs) {
      if (&other == &output) break;
      if (other.file.empty() || !IsSamePlace(output.file, other.file)) continue;
      throw InputError(fmt::format("--{}={}: is the file of --{} too, expected another one.",
                                   output.name,
                                   output.file,
                                   other.name));
    }
    RequireWritableFile(output.file);
  }
}

}  // namespace fathom
