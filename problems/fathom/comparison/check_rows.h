// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/findings/finding.h"
#include "fathom/findings/inertia_check.h"
#include "fathom/identification/identification.h"

#include <optional>
#include <span>
#include <vector>

namespace fathom {

// Holds the inertia of every usable row against the vehicle's body, if that is known: a warning of
// code "inertia" for each row that contradicts it.
std::vector<Finding> CheckRows(std::span<const Identification> rows,
                               const std::optional<Body>& body);

}  // namespace fathom
