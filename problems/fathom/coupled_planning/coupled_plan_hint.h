// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/coupled/fitted_coupled_model.h"

#include <string>
#include <string_view>

namespace fathom {

// The command that plans the run which tells the causes of a verdict apart, as other tools advise
// it:
//
//   fathom_plan --verdict=boat.json --limits=limits.yaml --duration=200 --out=plan
//
// The limits file is to be written: only who drives knows the place. The run lasts as long as the
// log, from 60 to 300 s. `text`: of the verdict file `file`. Empty where nothing is ambiguous that
// a wrench can tell apart, and where fathom_plan would refuse the file. Throws InputError if the
// text is no verdict file of several DOFs.
std::string CoupledPlanCommandOfVerdict(std::string_view text, const std::string& file);

}  // namespace fathom
