// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/batch_progress.h"
#include "fathom/archive/jobs/run_record.h"
#include "fathom/archive/store/store.h"

#include <functional>
#include <mutex>

namespace fathom {

// What the jobs of a batch share. They use the store, and show how far they are, one at a time:
// under the mutex.
struct BatchSession {
  Store* store = nullptr;
  std::function<void(const BatchProgress&)> show;  // empty: nobody looks
  std::mutex mutex;
};

// The store as a book of runs, which takes the mutex by itself.
RunBook BookOf(BatchSession* session);

}  // namespace fathom
