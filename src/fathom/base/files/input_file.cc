// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/files/input_file.h"

#include "fathom/base/input_error.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>
#include <vector>

#include <fmt/format.h>

namespace fathom {

void RequireRegularFile(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_regular_file(status)) return;
  if (!fs::exists(status)) {
    const bool is_link = fs::is_symlink(fs::symlink_status(path, error));
    const std::string target = is_link ? fs::read_symlink(path, error).string() : "";
    throw InputError(is_link
                         ? fmt::format("{}: is a link to {}, which is not there. Mend the link.",
                                       path.string(),
                                       target)
                         : path.string() + ": there is no such file. Check the path.");
  }
  throw InputError(fmt::format("{}: is a {}, expected a file.",
                               path.string(),
                               fs::is_directory(status) ? "folder"
                               : fs::is_fifo(status)    ? "pipe"
                                                        : "device"));
}

std::string ReadFile(const std::filesystem::path& path) {
  RequireRegularFile(path);
  std::error_code error;
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::string content;
  const auto size = std::filesystem::file_size(path, error);
  if (!error) content.reserve(size);
  std::vector<char> chunk(1 << 16);
  bool is_read = file.is_open();
  while (is_read && !file.eof()) {
    file.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
    content.append(chunk.data(), file.gcount());
    is_read = !file.bad();
  }
  if (!is_read) {
    const std::string reason = errno == 0 ? "unknown reason" : std::strerror(errno);
    throw InputError(path.string() + ": cannot read this file: " + reason + ".");
  }
  return content;
}

}  // namespace fathom
