// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/jobs/run_record.h"

#include <mutex>
#include <set>
#include <string>

namespace fathom {

// Which of the runs that pass through a book are not final (IsFinal). What is made of one is not
// done for good. For several threads at once.
class UnfinishedRuns {
 public:
  // The same book, watched. Use it only as long as this lives.
  RunBook Watch(RunBook book);

  bool IsEmpty() const;

 private:
  void Note(const RunRecord& run);

  mutable std::mutex mutex_;
  std::set<std::string> keys_;
};

}  // namespace fathom
