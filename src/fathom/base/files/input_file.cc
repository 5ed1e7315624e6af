// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/files/input_file.h"

#include "fathom/base/input_error.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>
#include <vector>

namespace fathom {

std::string ReadFile(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    throw InputError(path.string() + ": there is no such file. Check the path.");
  }
  if (std::filesystem::is_directory(path, error)) {
    throw InputError(path.string() + ": is a folder, expected a file.");
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::string content;
  const auto size = std::filesystem::file_size(path, error);  // none of a pipe
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
