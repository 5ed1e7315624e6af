// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/jobs/unfinished_runs.h"

#include <utility>

namespace fathom {

RunBook UnfinishedRuns::Watch(RunBook book) {
  return {.find =
              [this, find = std::move(book.find)](const std::string& key) {
                auto run = find(key);
                if (run) Note(*run);
                return run;
              },
          .keep =
              [this, keep = std::move(book.keep)](const RunRecord& run) {
                Note(run);
                keep(run);
              }};
}

bool UnfinishedRuns::IsEmpty() const {
  const std::lock_guard lock(mutex_);
  return keys_.empty();
}

// A run that is made again takes the place of the one before.
void UnfinishedRuns::Note(const RunRecord& run) {
  const std::lock_guard lock(mutex_);
  if (IsFinal(run)) {
    keys_.erase(run.key);
  } else {
    keys_.insert(run.key);
  }
}

}  // namespace fathom
