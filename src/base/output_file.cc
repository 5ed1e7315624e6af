// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/output_file.h"

#include "fathom/base/input_error.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>
#include <vector>

#include <unistd.h>

namespace fathom {
namespace {

// Makes and removes the temporary that is to be beside `path`.
void TryTemporaryOf(const std::filesystem::path& path) {
  std::error_code error;
  // Folders that are missing are made, and removed again from the innermost on.
  std::vector<std::filesystem::path> made;
  for (auto folder = path.parent_path(); !folder.empty() && !std::filesystem::exists(folder, error);
       folder = folder.parent_path()) {
    made.push_back(folder);
  }
  if (!made.empty()) std::filesystem::create_directories(made.front(), error);
  std::filesystem::path temporary = path;
  temporary += ".part" + std::to_string(getpid());
  errno = 0;
  const bool can_write = std::ofstream(temporary, std::ios::binary).is_open();
  const std::string reason = std::strerror(errno);
  if (can_write) std::filesystem::remove(temporary, error);
  for (const auto& folder : made) std::filesystem::remove(folder, error);
  if (!can_write) throw InputError(path.string() + ": cannot write this file: " + reason + ".");
}

}  // namespace

void WriteFile(const std::filesystem::path& path, std::string_view content) {
  std::error_code error;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
  std::filesystem::path temporary = path;
  temporary += ".part" + std::to_string(getpid());
  {
    std::ofstream file(temporary, std::ios::binary);
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
    file.close();
    if (!file) {
      const std::string reason = std::strerror(errno);
      std::filesystem::remove(temporary, error);
      throw InputError(path.string() + ": cannot write this file: " + reason + ".");
    }
  }
  std::filesystem::rename(temporary, path, error);
  if (error) {
    const std::string reason = error.message();
    std::filesystem::remove(temporary, error);
    throw InputError(path.string() + ": cannot write this file: " + reason + ".");
  }
}

void RequireWritableFile(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    throw InputError(path.string() + ": is a folder, expected a file to write.");
  }
  TryTemporaryOf(path);
}

void RequireWritableFolder(const std::filesystem::path& path) { TryTemporaryOf(path); }

}  // namespace fathom
