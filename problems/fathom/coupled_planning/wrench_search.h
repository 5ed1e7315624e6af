// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled_planning/coupled_limits.h"
#include "fathom/coupled_planning/rival_sigmas.h"
#include "fathom/coupled_planning/wrench_allocation.h"
#include "fathom/coupled_planning/wrench_block.h"
#include "fathom/coupled_planning/wrench_run.h"
#include "fathom/vehicle/coupled/coupled_model.h"
#include "fathom/vehicle/coupled/free_entry.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace fathom {

struct WrenchTask {
  std::vector<WrenchAxis> axes;
  CoupledLimits limits;
  double duration = 0.0;             // [s], of whole cells
  std::vector<CoupledModel> models;  // that must keep the limits, all of them
  // That must give the wrench; they must give the one that holds every axis. None: any are taken.
  std::optional<WrenchAllocation> thrusters = {};

  // A command is worth ln det(M + so_far), M what the first of `models` tells of the model's
  // entries. These are the first of `entries`, as many as `so_far` has rows.
  std::vector<FreeEntry> entries;
  WrenchMeasurement measurement;
  Eigen::MatrixXd so_far;

  // Beside rivals it is worth WorthOfSigmas(), and its ln det for each entry for a small share.
  std::vector<PlacedRival> rivals = {};  // rows of `entries`

  int num_starts = 2;       // at least 1
  int drawn_per_block = 8;  // of which the best is taken
  int num_moves = 100;      // changes tried of the best start; of each, a fifth
  std::uint64_t seed = 1;
};

struct FoundWrench {
  std::vector<WrenchBlock> blocks;  // empty: no command keeps the limits
  double value = -std::numeric_limits<double>::infinity();
  std::vector<std::vector<WrenchBlock>> before;  // those that were changed to it, the first first
};

// The sequence of blocks of greatest measure that keeps the limits, as SearchCommand() finds it of
// one axis: built block by block, then changed as long as the measure grows. The same task gives
// the same command to the bit.
FoundWrench SearchWrench(const WrenchTask& task);

}  // namespace fathom
