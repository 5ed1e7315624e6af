// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/batch.h"
#include "fathom/archive/report/archive_report.h"
#include "fathom/archive/store/tables.h"

#include <string>
#include <vector>

namespace fathom {

// What stands behind "log 120 of 1000" on a terminal: ", 34 a minute, 26 min left; last failure:
// dive 3/run 1: timed_out". `seconds`: since the first one began.
std::string PaceText(const BatchProgress& progress, double seconds);

// The account of a batch: everything found, by state; what changed; each log without a model, with
// the reason.
std::string FormatSummary(const BatchSummary& summary, const Tables& tables);

// What the archive page shows.
ArchiveReport ReportOf(const BatchOptions& options,
                       const BatchSummary& summary,
                       Tables tables,
                       PageOrigin origin);

// What a batch would do.
std::string FormatPlan(const BatchPlan& plan, const std::string& version);

// The table `fits` as CSV.
std::string FormatFitsCsv(const std::vector<FitRow>& fits);

}  // namespace fathom
