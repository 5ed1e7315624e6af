// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/recording/byte_file.h"

#include "fathom/base/input_error.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::size_t kWindow = std::size_t{1} << 18;  // [bytes], so that it stays in the cache

}  // namespace

ByteFile::ByteFile(const std::filesystem::path& path) : path_(path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) {
    throw InputError(path.string() + ": there is no such file. Check the path.");
  }
  if (status.type() != std::filesystem::file_type::regular) {
    throw InputError(path.string() + ": is no regular file, expected a recording.");
  }
  errno = 0;
  file_.open(path, std::ios::binary);
  size_ = std::filesystem::file_size(path, error);
  if (!file_.is_open() || error) {
    const std::string reason = errno == 0 ? "unknown reason" : std::strerror(errno);
    throw InputError(path.string() + ": cannot read this file: " + reason + ".");
  }
}

std::string_view ByteFile::View(std::uint64_t offset, std::size_t count) {
  offset = std::min(offset, size_);
  count = static_cast<std::size_t>(std::min<std::uint64_t>(count, size_ - offset));
  if (offset < begin_ || offset + count > begin_ + window_.size()) {
    begin_ = offset;
    const auto left = size_ - offset;
    window_.resize(
        static_cast<std::size_t>(std::min<std::uint64_t>(std::max(kWindow, count), left)));
    file_.clear();
    file_.seekg(static_cast<std::streamoff>(offset));
    file_.read(window_.data(), static_cast<std::streamsize>(window_.size()));
    if (file_.gcount() != static_cast<std::streamsize>(window_.size())) {
      throw InputError(fmt::format("{}: cannot read the bytes from {} on, expected {} in the file.",
                                   path_.string(),
                                   offset,
                                   size_));
    }
  }
  return std::string_view(window_).substr(static_cast<std::size_t>(offset - begin_), count);
}

std::string ByteFile::Copy(std::uint64_t offset, std::uint64_t count) {
  count = std::min(count, size_ - std::min(offset, size_));
  std::string bytes;
  bytes.reserve(static_cast<std::size_t>(count));
  while (bytes.size() < count) {
    const auto left = static_cast<std::size_t>(count - bytes.size());
    bytes += View(offset + bytes.size(), std::min(kWindow, left));
  }
  return bytes;
}

}  // namespace fathom
