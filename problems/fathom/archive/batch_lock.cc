// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/batch_lock.h"

#include "fathom/base/files/output_file.h"
#include "fathom/base/input_error.h"

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

namespace fathom {

BatchLock::BatchLock(const std::filesystem::path& results) {
  const std::string name = results.string() + ".lock";
  MakeFolderOf(results);
  file_ = open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (file_ < 0) {
    throw InputError(fmt::format("{}: cannot be written: {}.", name, std::strerror(errno)));
  }
  if (flock(file_, LOCK_EX | LOCK_NB) == 0) return;
  const int error = errno;
  close(file_);
  if (error == EWOULDBLOCK) {
    throw InputError(fmt::format(
        "--results={}: another batch is writing it, expected one at a time.", results.string()));
  }
  throw InputError(fmt::format("{}: cannot be locked: {}.", name, std::strerror(error)));
}

BatchLock::~BatchLock() { close(file_); }

WorkFolder::WorkFolder(std::filesystem::path path) : path_(std::move(path)) {
  std::error_code error;
  std::filesystem::remove_all(path_, error);
  std::filesystem::create_directories(path_, error);
  if (error) {
    throw InputError(fmt::format("{}: cannot be made: {}.", path_.string(), error.message()));
  }
}

WorkFolder::~WorkFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace fathom
