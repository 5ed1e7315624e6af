// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/coupled_fit.h"
#include "fathom/log/log.h"
#include "fathom/simulate/coupled/coupled_data.h"
#include "fathom/vehicle/coupled/motion_structure.h"

#include <span>
#include <vector>

namespace fathom {

// Logs and what a coupled fit takes of them, in the same order.
struct CoupledLogs {
  std::vector<Log> logs;
  std::vector<CoupledData> data;
};

// FitCoupled() by blocks: DOFs that move independently of each other are fitted by themselves. A
// block of one DOF whose model is docs/models.md (1) is FitOutputError() as it stands, to the bit.
//
// `logs.logs` may be empty: then no block is left to FitOutputError(). Throws InputError as both
// do.
CoupledSummary FitBlocks(const CoupledLogs& logs,
                         const MotionStructure& structure,
                         const CoupledFitOptions& options);

}  // namespace fathom
