// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/coupled/coupled_model.h"
#include "fathom/vehicle/coupled/free_entry.h"

#include <vector>

namespace fathom {

// Those that the model holds beside its nulls: 1 of a thrust gain, infinite of a bound, 0 of any
// other. Of a stuck fin every angle counts.
std::vector<FreeEntry> EntriesIn(const CoupledModel& model);

double ValueIn(const CoupledModel& model, const FreeEntry& entry);
void SetValue(const FreeEntry& entry, double value, CoupledModel* model);

}  // namespace fathom
