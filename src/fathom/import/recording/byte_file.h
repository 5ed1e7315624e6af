// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace fathom {

// A file of any size, seen through a window that moves over it.
class ByteFile {
 public:
  // Throws InputError, naming the file, if it is no regular file or cannot be read.
  explicit ByteFile(const std::filesystem::path& path);

  std::uint64_t size() const { return size_; }
  const std::filesystem::path& path() const { return path_; }

  // The `count` bytes from `offset` on, fewer at the end of the file. They last until the next
  // call. Throws InputError if they cannot be read.
  std::string_view View(std::uint64_t offset, std::size_t count);

  // The same, copied.
  std::string Copy(std::uint64_t offset, std::uint64_t count);

 private:
  std::filesystem::path path_;
  std::ifstream file_;
  std::uint64_t size_ = 0;
  std::uint64_t begin_ = 0;  // of the window
  std::string window_;
};

}  // namespace fathom
