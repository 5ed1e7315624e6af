// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/findings/finding.h"
#include "fathom/log/log.h"
#include "fathom/signal/segment.h"

#include <optional>
#include <span>

namespace fathom {

// Whether other axes act on this one: what a model of this DOF alone misses moves with a product of
// two other velocities of the log, as a Coriolis or Munk term does ("v r" in surge). `segments`: of
// that log. The regression of least squares (docs/least_squares.md (1)) in means over 2 s, with and
// without the product; docs/findings.md (9).
std::optional<Finding> CheckOtherAxes(const Log& log, Dof dof, std::span<const Segment> segments);

}  // namespace fathom
