// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/files/output_file.h"

#include "fathom/base/files/temporary.h"
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

namespace fs = std::filesystem;

[[noreturn]] void RefuseToWrite(const fs::path& path, const std::string& reason) {
  throw InputError(path.string() + ": cannot write this file: " + reason + ".");
}

// A device, a pipe or a socket, or an open file by one of the names that the system has for it: it
// is written into. A file in its place would take it from every other process.
bool IsDevice(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) return false;
  const std::string name = fs::absolute(path, error).lexically_normal().string();
  const bool is_open_file =
      name.starts_with("/dev/std") || name.starts_with("/dev/fd/") || name.starts_with("/proc/");
  return is_open_file || fs::is_other(path, error);
}

void WriteInto(const fs::path& file, std::string_view content, const fs::path& named) {
  errno = 0;
  // At the end: /dev/stdout may be a file that has lines already.
  std::ofstream stream(file, std::ios::binary | std::ios::app);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  if (!stream) RefuseToWrite(named, std::strerror(errno));
}

// Makes and removes the temporary that is to be beside `path`. The error there was; 0: none.
int ErrorOfTemporary(const fs::path& path) {
  std::error_code error;
  std::error_code ignored;
  // Folders that are missing are made, and removed again from the innermost on.
  std::vector<fs::path> made;
  for (auto folder = path.parent_path(); !folder.empty() && !fs::exists(folder, error);
       folder = folder.parent_path()) {
    made.push_back(folder);
  }
  if (!made.empty() && !fs::create_directories(made.front(), error) && error) {
    for (const auto& folder : made) fs::remove(folder, ignored);
    return error.value();
  }
  const Temporary temporary(path);
  errno = 0;
  const bool can_write = std::ofstream(temporary.path(), std::ios::binary).is_open();
  const int reason = can_write ? 0 : errno;
  if (can_write) fs::remove(temporary.path(), error);
  for (const auto& folder : made) fs::remove(folder, error);
  return reason;
}

// Again where the folder is gone that was there: another program that tries the same removes what
// it made.
void TryTemporaryOf(const fs::path& path) {
  constexpr int kMostTimes = 20;
  int reason = ENOENT;
  for (int i = 0; i < kMostTimes && reason == ENOENT; ++i) reason = ErrorOfTemporary(path);
  if (reason != 0) RefuseToWrite(path, std::strerror(reason));
}

}  // namespace

void WriteFile(const fs::path& path, std::string_view content) {
  if (IsDevice(path)) return WriteInto(path, content, path);
  MakeFolderOf(path);
  const Temporary temporary(path);
  WriteInto(temporary.path(), content, path);
  temporary.TakePlace();
}

void MakeFolderOf(const fs::path& file) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  if (error) RefuseToWrite(file, error.message());
}

void RequireWritableFile(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) {
    throw InputError(path.string() + ": is a folder, expected a file to write.");
  }
  if (!IsDevice(path)) return TryTemporaryOf(path);
  if (access(path.c_str(), W_OK) != 0) RefuseToWrite(path, std::strerror(errno));
}

void RequireWritableFolder(const fs::path& path) { TryTemporaryOf(path); }

}  // namespace fathom
