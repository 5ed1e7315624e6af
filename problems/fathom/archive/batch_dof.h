// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"

#include <limits>
#include <string>

namespace fathom {

// One DOF of a log, for the joint fit of its dive.
struct BatchDof {
  Dof dof = Dof::kSurge;
  std::string why_left_out;  // empty: it is to be fitted with the others
  double own_nmae = std::numeric_limits<double>::quiet_NaN();  // of its own model by output error
};

}  // namespace fathom
