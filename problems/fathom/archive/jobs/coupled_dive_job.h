// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/jobs/dive_jobs.h"
#include "fathom/archive/jobs/run_program.h"

#include <string>
#include <vector>

namespace fathom {

// The logs of one dive that have a coupled model of these DOFs.
struct CoupledDiveTask {
  std::string vehicle, dive;
  std::string dofs;               // "surge,sway,yaw"
  bool coriolis = false;          // whether C(nu) acts
  std::vector<std::string> free;  // entries beyond a diagonal model
  std::vector<DiveLog> logs;
};

// One coupled model of all of them (fathom_identify --dofs), whose structure is given: dives can be
// compared that free the same numbers. Its output is the model.
RunRecord RunCoupledDiveJob(const CoupledDiveTask& task,
                            const ProgramSettings& settings,
                            const RunBook& book);

}  // namespace fathom
