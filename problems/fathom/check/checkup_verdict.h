// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/check/log_checkup.h"

#include <string>
#include <vector>

namespace fathom {

// What comes first, in one sentence: what is red, and what can be identified.
std::string Verdict(const LogCheckup& checkup);

// What to do with this log now: a command, where there is one.
std::string NextStep(const LogCheckup& checkup);

// Commands that plan the experiment which tells what this log leaves unknown, each for the model
// file that NextStep() writes, into a folder of its own; none where all is known, or fathom_plan
// would refuse the model.
std::vector<std::string> PlanSteps(const LogCheckup& checkup);

// The DOFs that a model comes of.
std::vector<std::string> UsableDofs(const LogCheckup& checkup);

}  // namespace fathom
