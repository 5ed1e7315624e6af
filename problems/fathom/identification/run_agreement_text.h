// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/identification/run_agreement.h"
#include "fathom/report/table.h"
#include "fathom/vehicle/parameters.h"

#include <string>
#include <vector>

namespace fathom {

// Each run's own parameters, a row each, and a last one with chi-square over its degrees of
// freedom.
Table RunTable(const RunAgreement& agreement, Dof dof, const std::string& force_unit);

// What is to be said of it, a sentence each: which parameters' intervals were widened and by how
// much (`widening`), and which run stands apart. Empty where the runs agree.
std::vector<std::string> RemarksOn(const RunAgreement& agreement, const ParameterVector& widening);

}  // namespace fathom
