// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

namespace fathom {

// Keeps a second batch from the same results while this one lives. Beside them stands a file
// `<results>.lock`, which stays; their folder is made where it is missing. Throws InputError if
// another batch holds it. A lock goes with its process, however that ends.
class BatchLock {
 public:
  explicit BatchLock(const std::filesystem::path& results);
  ~BatchLock();
  BatchLock(const BatchLock&) = delete;
  BatchLock& operator=(const BatchLock&) = delete;

 private:
  int file_;
};

// An empty folder that is gone in the end; what an earlier batch left in it is removed first.
class WorkFolder {
 public:
  explicit WorkFolder(std::filesystem::path path);
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

 private:
  std::filesystem::path path_;
};

}  // namespace fathom
