// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/batch_progress.h"
#include "fathom/archive/log_batch.h"
#include "fathom/archive/store/store.h"
#include "fathom/archive/store/tables.h"

#include <functional>
#include <string>
#include <vector>

namespace fathom {

struct DiveBatch {
  Tables tables;                   // of whole dives
  std::vector<std::string> dives;  // in their order
  bool is_final = true;            // false: a later batch has to do it again
};

// Fits all logs of each dive together, lets each dive's model predict the next dive of the same
// vehicle, and looks for changes over the dives.
DiveBatch RunDives(const std::vector<DoneLog>& logs,
                   const LogBatchOptions& options,
                   int at_a_time,
                   Store* store,
                   const std::function<void(const BatchProgress&)>& show);

// The dives of stored logs, in their order.
std::vector<std::string> DivesOf(const Tables& tables);

}  // namespace fathom
