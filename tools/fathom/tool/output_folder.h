// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace fathom {

// The folder that --out names: a new or empty one, or, with `overwrite`, one that holds a log and
// nothing that Fathom could not have written: a camera's images or a video cannot be made
// again. `images`: what of these the program writes itself, the folder `frames` or a video by its
// name. Throws InputError for any other folder.
std::filesystem::path OutputFolder(const std::string& out,
                                   bool overwrite,
                                   const std::string& images = "");

// Throws InputError, naming the flag, if the file that it asks for lies in the output folder. No
// file: an empty name.
void RequireOutside(const std::filesystem::path& folder,
                    std::string_view flag,
                    const std::string& file);

}  // namespace fathom
