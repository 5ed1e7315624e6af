// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/findings/finding.h"
#include "fathom/identification/identification.h"
#include "fathom/log/log.h"

#include <optional>

namespace fathom {

// How many dry masses of the log's vehicle the inertia of a model is, where that is more than
// UsualInertia(); nothing where it is not, the model is not usable, or no mass is known.
std::optional<double> UnusualMasses(const Log& log, Dof dof, const Identification& model);

// The same as a note, `heavy`.
std::optional<Finding> CheckUsualMass(const Log& log, Dof dof, const Identification& model);

}  // namespace fathom
