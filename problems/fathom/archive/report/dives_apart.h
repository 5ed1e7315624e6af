// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/store/tables.h"

#include <string>

namespace fathom {

// Says which parameter of a vehicle differs most between dives, where dives differ by far more than
// their intervals: how far, and which dives stand together. For example of dives in pairs, each
// pair with another hull, where no step can be placed. Parameters that have a change in `changes`
// are left to it, and DOFs that a coupled model stands for to that (CoupledDofsCompared). Empty
// where the dives agree, or too few say something (kFewestDivesForChange).
std::string DivesApartSentence(const Tables& tables, const std::string& vehicle);

}  // namespace fathom
