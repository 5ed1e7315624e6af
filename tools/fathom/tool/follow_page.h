// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/adaptive/adaptive_identifier.h"
#include "fathom/base/dof.h"
#include "fathom/report/page.h"
#include "fathom/tool/estimate_history.h"

namespace fathom {

// The estimates of a stream over time with their intervals, 1.96 times the scatter;
// docs/adaptive.md, "On line". The first tenth is left out; those that are not usable
// are gaps. The history must not be empty.
Page FollowPage(const EstimateHistory& history, Dof dof, const AdaptiveOptions& options);

}  // namespace fathom
