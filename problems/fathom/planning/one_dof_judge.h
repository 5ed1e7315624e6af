// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/command_judge.h"
#include "fathom/planning/plan_limits.h"
#include "fathom/vehicle/extended_model.h"

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace fathom {

// How much a command is worth; minus infinity: nothing. Without stamps: what no command is worth.
using CommandMeasure =
    std::function<double(const HeldCommand& command, std::span<const double> stamps)>;

struct OneDofQuestion {
  Dof dof = Dof::kSurge;
  PlanLimits limits;
  std::vector<double> stamps;         // at which the measure looks at the motion, to the plan's end
  std::vector<double> limit_stamps;   // at which it is held against the limits
  std::vector<ExtendedModel> models;  // that must keep the limits, all of them: one at least
  CommandMeasure measure;
};

// Judges commands of one axis. The limits of speed and distance are multiplied by `share`.
// `question` must outlive the judge.
std::unique_ptr<CommandJudge> OneDofJudge(const OneDofQuestion& question, double share);

}  // namespace fathom
