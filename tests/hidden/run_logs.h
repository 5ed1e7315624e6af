// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "log_plan.h"
#include "oracle_cache.h"
#include "score.h"

namespace fathom::hidden {

// Draws every log, asks the oracle, diagnoses by `options` and scores, `num_threads` logs at a
// time. The scores come in the order of the plans, whatever the number of threads; `report` is
// called as each is done, by one thread at a time.
std::vector<LogScore> RunLogs(const std::vector<LogPlan>& plans,
                              std::uint64_t seed,
                              int num_threads,
                              OracleCache& oracle,
                              const DiagnosisOptions& options = {},
                              const std::function<void(const LogScore&)>& report = {});

}  // namespace fathom::hidden
