// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/coupled_diagnosis.h"
#include "fathom/report/page.h"

#include <string>

namespace fathom {

// A page on a model of several DOFs: what the data show beyond the diagonal model, measured and
// simulated motion of each DOF, the ladder of structures, and the matrices. Its origin is left
// open. `plan_command` as for CoupledNextSteps().
Page CoupledPage(const CoupledDiagnosis& diagnosis,
                 const CoupledIdentification& identified,
                 const std::string& plan_command = "");

}  // namespace fathom
