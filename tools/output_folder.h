// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace fathom {

// The folder that --out names: a new or empty one, or, with `overwrite`, one that holds a log and
// nothing that Fathom could not have written: a camera's images or a video cannot be made
// again. `makes_images`: the program writes a folder `frames` itself. Throws InputError for any
// other folder.
std::filesystem::path OutputFolder(const std::string& out,
                                   bool overwrite,
                                   bool makes_images = false);

// Throws InputError, naming the flag, if the file that it asks for lies in the output folder. No
// file: an empty name.
void RequireOutside(const std::filesystem::path& folder,
                    std::string_view flag,
                    const std::string& file);

// A folder that takes its final name only once it is complete; what is not finished leaves nothing
// behind.
class FolderInTheMaking {
 public:
  explicit FolderInTheMaking(const std::filesystem::path& folder);
  ~FolderInTheMaking();
  FolderInTheMaking(const FolderInTheMaking&) = delete;
  FolderInTheMaking& operator=(const FolderInTheMaking&) = delete;

  // Where to write until then.
  const std::filesystem::path& path() const { return temporary_; }

  // Replaces whatever has the name. Throws InputError if that is not possible.
  void Finish() const;

 private:
  std::filesystem::path folder_;
  std::filesystem::path temporary_;
};

}  // namespace fathom
