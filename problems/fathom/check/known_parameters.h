// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/check/log_checkup.h"

#include <string_view>

namespace fathom {

// Of a fitted parameter.
double StdOf(const FittedModel& model, int index);

// Whether something biases the model that no interval of it holds: what is red, or another axis.
bool IsBiased(const LogCheckup& checkup, const DofCheckup& dof);

// "well": the 95 % interval is within 20 % of the value, of the buoyancy within 20 % of the
// greatest force; "roughly": within 100 %; "not"; or, of a biased model, "in doubt". Of a usable
// model. Where the data do not tell a delay of the command, with an unknown one.
std::string_view HowWellKnown(const LogCheckup& checkup, const DofCheckup& dof, int index);

}  // namespace fathom
