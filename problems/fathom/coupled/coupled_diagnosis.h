// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/coupled_identification.h"
#include "fathom/findings/finding.h"
#include "fathom/findings/verdict.h"

#include <array>
#include <vector>

namespace fathom {

// What the diagonal model of several DOFs gets wrong, and which numbers mend it; docs/coupled.md.
// Of effects in time or in a sensor fathom_diagnose --dof tells.
struct CoupledDiagnosis {
  Verdict verdict = Verdict::kUnexplained;

  // Numbers beyond the diagonal model and C(nu) that the data force, as the accepted model has
  // them.
  std::vector<NamedEntry> causes;

  // By Index(Dof), of modelled ones: the NMAE of free runs of a window's length, and the NMAE that
  // scatter from sample to sample alone gives. Above three times this the model misses motion. NaN
  // where too little was measured.
  std::array<double, 6> run_nmae, scatter_nmae;
  std::vector<Dof> missed;  // the DOFs above it

  std::vector<Finding> findings;  // on the data
};

// `identified`: usable, its structure chosen by ClimbLadder(). `findings`: of CheckLogs().
CoupledDiagnosis DiagnoseCoupled(const CoupledIdentification& identified,
                                 std::vector<Finding> findings);

}  // namespace fathom
