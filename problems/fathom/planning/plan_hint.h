// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/fitted_model.h"

#include <string>
#include <string_view>

namespace fathom {

// The command to type that plans the next experiment, as other tools advise it:
//
//   fathom_plan --model=surge.json --duration=120 --out=plan
//
// It lasts as long as the log, from 60 to 300 s, and goes no further than the log in force and
// speed. Empty where fathom_plan would refuse the file.

// From the file of a model, into the folder `out`.
std::string PlanCommandOfModel(const FittedModel& fitted,
                               const std::string& file,
                               const std::string& out = "plan");

// From a verdict file with this text, if it is ambiguous between causes that an experiment along
// its DOF can tell apart; else empty. Throws InputError if the text is no verdict file.
std::string PlanCommandOfVerdict(std::string_view text, const std::string& file);

}  // namespace fathom
