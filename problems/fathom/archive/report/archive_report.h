// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/dives/nearly_log.h"
#include "fathom/archive/store/tables.h"
#include "fathom/report/page_origin.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace fathom {

// What the archive page shows.
struct ArchiveReport {
  std::string archive;  // its folder, as it was named
  PageOrigin origin;    // without logs: the archive stands for them
  Tables tables;
  std::vector<std::string> dives;          // in their order
  std::map<std::string, int> other_files;  // files that are no logs, by their ending
  std::vector<NearlyLog> nearly_logs;
  // Pages of the diagnoses, relative to the archive page, by (log, dof). May be empty.
  std::map<std::pair<std::string, std::string>, std::string> pages;
};

}  // namespace fathom
