// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/adaptive/adaptive_follower.h"
#include "fathom/base/dof.h"

#include <string>

namespace fathom {

// What fathom_follow prints, docs/adaptive.md, "On line". All numbers have the digits that make
// them again; those that are not known are empty cells, and null in JSON.

// "t,inertia,...,inertia_std,...,usable\n".
std::string EstimateCsvHeader();

// A line of CSV, of the columns above.
std::string EstimateCsvLine(const FollowedEstimate& estimate);

// A line of JSON: {"t": ..., "usable": ..., "parameters": {"inertia": {"value", "std", "unit"},
// ...}}.
std::string EstimateJsonLine(const FollowedEstimate& estimate, Dof dof);

}  // namespace fathom
