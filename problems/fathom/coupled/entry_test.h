// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/coupled_fit.h"
#include "fathom/vehicle/coupled/free_entry.h"

#include <span>
#include <vector>

namespace fathom {

// Whether a number that a model lacks is in the data: a score test. `z` is about a standard normal
// number where it is not.
struct EntryTest {
  FreeEntry entry;
  double z = 0.0;
  double value = 0.0;  // what one step of a fit would give it, less what it is held at

  // Whether it is one and the same in the data as another candidate: of the directions that both
  // would take the residuals, the correlation.
  std::vector<double> likeness;  // to each candidate, in their order
};

// Tests candidates at a fit of `logs`, one by one, all numbers of the fit free beside each. A
// thrust gain counts from 1, others from what the model holds. Nothing where a run diverges.
std::vector<EntryTest> TestEntries(std::span<const CoupledData> logs,
                                   const CoupledSummary& fit,
                                   const std::vector<FreeEntry>& candidates,
                                   const CoupledFitOptions& options);

// How likely all candidates together stand out as they do where none of them is in the data:
// chi-squared, with their likeness. Of the tests of all candidates; 1 of none.
double JointPValue(std::span<const EntryTest> tests);

}  // namespace fathom
