// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

namespace fathom {

// The name of a file or folder while it is written: beside the place it is for, with the same
// ending. What never takes its place is removed, by the destructor or when the process is
// interrupted (RemoveTemporariesOnInterrupt()).
class Temporary {
 public:
  // `place`: where the result goes. Of a symbolic link, what it points to; the link stays.
  explicit Temporary(const std::filesystem::path& place);
  ~Temporary();
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  // Where to write. Makes nothing itself.
  const std::filesystem::path& path() const { return path_; }

  // Gives what was written its place. A folder replaces whatever was there, a file only a file.
  // Throws InputError, naming the place, if that is not possible.
  void TakePlace() const;

 private:
  std::filesystem::path named_;  // as the caller named the place
  std::filesystem::path place_;
  std::filesystem::path path_;
};

// From now on SIGINT, SIGTERM and SIGHUP end the process only once its temporaries are removed.
// Signals that are ignored stay so. To be called before the process has a second thread.
void RemoveTemporariesOnInterrupt();

}  // namespace fathom
