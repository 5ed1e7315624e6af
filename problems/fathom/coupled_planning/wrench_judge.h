// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled_planning/coupled_limits.h"
#include "fathom/coupled_planning/rival_sigmas.h"
#include "fathom/coupled_planning/wrench_allocation.h"
#include "fathom/coupled_planning/wrench_run.h"
#include "fathom/planning/command_judge.h"
#include "fathom/vehicle/coupled/coupled_model.h"
#include "fathom/vehicle/coupled/free_entry.h"

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace fathom {

struct WrenchQuestion {
  std::vector<WrenchAxis> axes;
  CoupledLimits limits;
  double duration = 0.0;             // of the plan [s]
  std::vector<CoupledModel> models;  // that must keep the limits, all of them: one at least
  // That must give the wrench; they must give the one that holds every axis. None: any are taken.
  std::optional<WrenchAllocation> thrusters = {};

  // A command is worth ln det(M + so_far), M what the first of `models` tells of the model's
  // entries. These are the first of `entries`, as many as `so_far` has rows.
  std::vector<FreeEntry> entries;
  WrenchMeasurement measurement;
  Eigen::MatrixXd so_far;

  // Beside rivals it is worth WorthOfSigmas(), and its ln det for each entry for a small share.
  std::vector<PlacedRival> rivals = {};  // rows of `entries`
};

// Judges commands of several axes. The limits of motion are multiplied by `share`. `question` must
// outlive the judge.
std::unique_ptr<CommandJudge> WrenchJudge(const WrenchQuestion& question, double share);

}  // namespace fathom
