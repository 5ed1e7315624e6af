// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/structure_ladder.h"
#include "fathom/log/log.h"
#include "fathom/simulate/coupled/coupled_data.h"
#include "fathom/simulate/coupled/coupled_prediction.h"
#include "fathom/vehicle/coupled/fitted_coupled_model.h"
#include "fathom/vehicle/coupled/free_entry.h"
#include "fathom/vehicle/coupled/motion_structure.h"

#include <optional>
#include <string>
#include <vector>

namespace fathom {

struct CoupledIdentificationOptions {
  std::vector<Dof> dofs;                       // in the order of Dof, each once
  std::optional<StandardStructure> structure;  // absent: chosen by ClimbLadder()
  CoupledFitOptions fit;
  std::vector<FreeEntry> also_free = {};  // beside those of `structure`, which is given
};

struct CoupledIdentification {
  bool is_usable = false;
  std::string message;  // why not
  FittedCoupledModel fitted;
  std::vector<std::string> caveats_on_fit;  // those of fitted.caveats that are of this fit alone
  CoupledSummary fit;
  std::optional<Ladder> ladder;  // where the structure was chosen

  MotionStructure structure;      // what is free
  CoupledFitOptions fit_options;  // with what the vehicle file tells

  std::vector<CoupledData> data;              // the logs as the fit took them
  CoupledPrediction prediction;               // free runs of a window's length, where usable
  std::optional<CoupledPrediction> diagonal;  // the same of the ladder's first rung
  std::vector<std::string> remarks;
};

// One model of several DOFs from one or several logs. The first vehicle file that a log names
// tells the rigid body and the thrusters.
//
// Throws InputError if the logs lack what CoupledDataOf() needs, differ in their command's unit, or
// know nothing of what an entry of `also_free` is of.
CoupledIdentification IdentifyCoupled(std::vector<Log> logs,
                                      const CoupledIdentificationOptions& options);

}  // namespace fathom
