// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/comparison/comparison.h"

#include <optional>

namespace fathom {

// Holds the inertia of every usable row against the vehicle's dry mass [kg], if that is known: a
// warning of code "inertia" for each row that contradicts it, before the other findings.
void CheckRows(std::optional<double> mass, DofComparison* comparison);

}  // namespace fathom
