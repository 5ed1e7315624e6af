// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/jobs/coupled_dive_job.h"
#include "fathom/archive/jobs/dive_jobs.h"
#include "fathom/archive/jobs/log_jobs.h"
#include "fathom/archive/store/tables.h"

#include <string>
#include <vector>

namespace fathom {

// The rows of one log but for `logs`: fits, scores, verdicts, causes, findings, out of what its
// programs wrote. A file that is damaged gives no rows.
Tables RowsOfLog(const LogOutcome& outcome);

// The rows of one dive and DOF in dive_fits: one for each parameter, or a single one without a
// parameter where there is no usable fit. `excluded`: logs that were not given to the fit, and why.
std::vector<DiveFitRow> RowsOfDive(const DiveTask& task,
                                   const DiveOutcome& outcome,
                                   const std::vector<LeftOutLog>& excluded);

// Likewise of the coupled fit of a dive.
std::vector<DiveFitRow> RowsOfCoupledDive(const CoupledDiveTask& task, const RunRecord& run);

}  // namespace fathom
