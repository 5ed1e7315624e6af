// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/coupled_fit_options.h"
#include "fathom/coupled/coupled_summary.h"
#include "fathom/simulate/coupled/coupled_data.h"
#include "fathom/vehicle/coupled/motion_structure.h"

#include <span>

namespace fathom {

// The numbers of a structure with which free runs of all `logs`, window by window, come nearest to
// what was measured: output error with each channel's own coloured noise, docs/coupled.md. Held-out
// segments are left alone.
//
// Throws InputError if options.Problems() is not empty. A poor fit does not throw: see the summary.
CoupledSummary FitCoupled(std::span<const CoupledData> logs,
                          const MotionStructure& structure,
                          const CoupledFitOptions& options = {});

}  // namespace fathom
