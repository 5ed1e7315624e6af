// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/batch_dof.h"
#include "fathom/archive/jobs/log_jobs.h"
#include "fathom/archive/log_contents.h"
#include "fathom/archive/store/known_log.h"

#include <optional>
#include <vector>

namespace fathom {

// What is kept of a log that is done, for a later batch.
KnownLog KnownLogOf(const LogOutcome& outcome, const std::vector<BatchDof>& dofs);

// The outcome as it was when the log was done, without the runs; nothing if it cannot be had, as
// where the log that was made of images is gone.
std::optional<LogOutcome> OutcomeOf(const KnownLog& known,
                                    const HashedLog& log,
                                    const LogJobOptions& options);
std::vector<BatchDof> DofsOf(const KnownLog& known);

}  // namespace fathom
