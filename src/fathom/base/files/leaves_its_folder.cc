// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/files/leaves_its_folder.h"

#include <algorithm>

namespace fathom {

bool LeavesItsFolder(const std::filesystem::path& path) {
  return path.is_absolute() ||
         std::any_of(path.begin(), path.end(), [](const auto& part) { return part == ".."; });
}

}  // namespace fathom
