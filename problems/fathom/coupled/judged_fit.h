// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/coupled_summary.h"
#include "fathom/coupled/window_problem.h"

namespace fathom {

// How sure a converged fit is, and what the data leave open: its covariance, the entries that are
// not determined, and those on a bound. `summary`: with its model, starts and noise. `huber_k`:
// from how many standard deviations on a residual counts linearly.
CoupledSummary Judged(CoupledSummary summary, const WindowProblem& problem, double huber_k);

}  // namespace fathom
