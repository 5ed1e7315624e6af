// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/dives/walk_archive.h"
#include "fathom/archive/store/store.h"

#include <string>
#include <vector>

namespace fathom {

// A log with what its files hold.
struct HashedLog {
  FoundLog log;
  std::string path;        // as text
  std::string content;     // empty if it cannot be read
  std::string unreadable;  // why
  std::string
      duplicate_of;  // the path of the first log of the same content; empty: it is the first
};

// Hashes every log, or takes its content from the store where names, sizes and times of change of
// its files are what they were; keeps the new ones there.
std::vector<HashedLog> HashLogs(const std::vector<FoundLog>& logs, bool rehash, Store* store);

}  // namespace fathom
