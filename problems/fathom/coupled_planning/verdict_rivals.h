// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled_planning/entry_rival.h"
#include "fathom/vehicle/coupled/fitted_coupled_model.h"

#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// What a verdict on several DOFs leaves open.
struct VerdictRivals {
  std::vector<EntryRival> pairs;      // that a wrench can tell apart, in the order of the file
  std::vector<std::string> left_out;  // the others, with the reason: a sentence each
};

// From the text of a verdict file ("fathom-verdict-2") and the model in it; `name` stands for the
// file in messages. Nothing of a verdict that is not `ambiguous`, and of a model file. Throws
// InputError for an entry that is none, and for a named one that the model did not identify.
VerdictRivals ReadVerdictRivals(const std::string& name,
                                std::string_view text,
                                const FittedCoupledModel& fitted);

}  // namespace fathom
