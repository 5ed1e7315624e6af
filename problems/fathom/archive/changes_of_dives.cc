// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/changes_of_dives.h"

namespace fathom {

DiveChanges ChangesOfDives(const std::vector<FittedDive>&,
                           const std::vector<std::string>&,
                           const std::map<std::string, std::filesystem::path>&) {
  return {};
}

}  // namespace fathom
