// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <string>

#include "hidden_log.h"
#include "oracle.h"

namespace fathom::hidden {

// The oracle's answers of earlier runs, by a fingerprint of the log's numbers and of the truth: a
// log that is drawn in any other way is asked afresh. One line each; not for keeping, the oracle's
// own code is not in the fingerprint.
class OracleCache {
 public:
  // Empty: nothing is kept.
  explicit OracleCache(const std::filesystem::path& file);

  // May be called by several threads.
  OracleAnswer Ask(const HiddenLog& hidden);

 private:
  std::filesystem::path file_;
  std::mutex mutex_;
  std::map<std::string, OracleAnswer> answers_;
};

}  // namespace fathom::hidden
