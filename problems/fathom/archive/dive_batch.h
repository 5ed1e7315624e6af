// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/batch_session.h"
#include "fathom/archive/coupled_dives.h"
#include "fathom/archive/jobs/dive_jobs.h"
#include "fathom/archive/jobs/run_in_parallel.h"
#include "fathom/archive/jobs/unfinished_runs.h"
#include "fathom/archive/log_batch.h"
#include "fathom/archive/store/tables.h"
#include "fathom/base/dof.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace fathom {

struct DiveBatch {
  Tables tables;                   // of whole dives
  std::vector<std::string> dives;  // in their order
  bool is_final = true;            // false: a later batch has to do it again
};

// A joint fit: a vehicle, a DOF, and the dive's place in the order of all dives.
using FitKey = std::tuple<std::string, Dof, int>;

// What the programs said of one joint fit.
struct FittedTask {
  DiveOutcome outcome;
  std::vector<PredictionRow> predictions;  // of the logs of the next dive
};

// The joint fits of a batch that were begun, whether or not they are done.
struct DiveRuns {
  std::map<FitKey, FittedTask> fits;
  std::map<CoupledFitKey, std::optional<RunRecord>> coupled;
  std::size_t num_done = 0;
  bool are_shown = false;  // as progress: not before all logs are done
  UnfinishedRuns unfinished;
};

// The joint fits, of all logs of a dive together, that may begin and have not begun: those whose
// logs are done, and the logs that the fit is to predict, which are of the vehicle's next dive.
// Call it under the mutex. `options`, `runs` and `session` must outlive the jobs.
std::vector<Job> NewDiveJobs(const std::vector<BatchLog>& logs,
                             const LogBatchOptions& options,
                             DiveRuns* runs,
                             BatchSession* session);

// The tables of whole dives, with the changes over them. `logs` and `runs` are done.
DiveBatch BatchOfDives(const std::vector<BatchLog>& logs, const DiveRuns& runs);

// The dives of stored logs, in their order.
std::vector<std::string> DivesOf(const Tables& tables);

}  // namespace fathom
