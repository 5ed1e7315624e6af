// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/planning/planned_motion.h"
#include "fathom/planning/rival_model.h"
#include "fathom/planning/stamp_noise.h"

#include <span>
#include <vector>

namespace fathom {

// A command and the stamps of its run.
struct RunSetting {
  Dof dof = Dof::kSurge;
  HeldCommand command;
  std::span<const double> stamps;
  StampNoise noise;
};

// A model as near to another one's motion as damped Gauss-Newton steps bring it.
struct RefittedModel {
  ExtendedModel model;
  double sigmas = 0.0;  // the root of the noncentrality that is left, docs/plan.md (3)
};
RefittedModel RefitTo(const PlannedMotion& motion,
                      const ExtendedModel& assumed,
                      const RunSetting& setting);

// The models of rivals as they would explain the log that the first one was fitted to: each
// refitted to the first one's motion under `setting`, which stands for that log.
std::vector<RivalModel> AgreeingRivals(std::vector<RivalModel> rivals, const RunSetting& setting);

// The separation of each ordered pair of rivals, truth before assumed, as the linear forecast of
// one damped step has it: for a search. Empty if a run diverges.
std::vector<double> QuickSeparations(std::span<const RivalModel> rivals, const RunSetting& setting);

}  // namespace fathom
