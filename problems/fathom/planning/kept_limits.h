// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/plan_limits.h"
#include "fathom/planning/planned_motion.h"

#include <span>
#include <vector>

namespace fathom {

// True if speed and distance stay within the limits at all stamps.
bool KeepsLimits(const PlannedMotion& motion, const PlanLimits& limits);

// The limits' force, halved until one hold of it, and the coast behind, keeps the limits: what is
// more is of no use. Of a model that keeps them under none, what is left after 40 halvings.
double UsableForce(const ExtendedModel& model, Dof dof, const PlanLimits& limits);

// How many of the models break the limits under a command, or diverge; counting ends above `most`.
int NumBreaking(std::span<const ExtendedModel> models,
                Dof dof,
                const HeldCommand& command,
                std::span<const double> stamps,
                const PlanLimits& limits,
                int most);

}  // namespace fathom
