// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/findings/finding.h"
#include "fathom/identification/identification.h"
#include "fathom/log/log.h"

#include <optional>

namespace fathom {

// In dry masses of the vehicle.
struct UnusualMass {
  double inertia = 0.0;
  double usual = 0.0;  // UsualInertia(), which is less
};

// Of the inertia of a model; nothing where it is usual, the model is not usable, or no mass is
// known.
std::optional<UnusualMass> UnusualMassOf(const Log& log, Dof dof, const Identification& model);

// The same as a note, `heavy`.
std::optional<Finding> CheckUsualMass(const Log& log, Dof dof, const Identification& model);

}  // namespace fathom
