// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled_planning/coupled_limits.h"
#include "fathom/coupled_planning/entry_rival.h"
#include "fathom/coupled_planning/wrench_allocation.h"
#include "fathom/planning/experiment_plan.h"
#include "fathom/planning/wrench_block.h"
#include "fathom/simulate/coupled/coupled_data.h"
#include "fathom/vehicle/coupled/fitted_coupled_model.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// What an experiment of several DOFs is planned from.
struct CoupledPlanRequest {
  FittedCoupledModel model;  // what is known so far
  std::string name;          // of its file, for messages
  CoupledLimits limits;
  std::string limits_name;
  std::vector<Dof> dofs;  // to command; empty: those that the limits give a force for
  double duration = 0.0;  // [s]
  std::uint64_t seed = 1;
  double effort = 1.0;  // share of the changes that are tried, above 0 to 1

  std::vector<EntryRival> rivals;  // to tell apart; none: the plan tells the entries

  // Logs of the vehicle that the model was not fitted to: what they tell need not be flown again.
  std::vector<CoupledData> flown;

  // Whose thrusters give the wrench; none: anything gives it. It must outlive the plan.
  const Vehicle* vehicle = nullptr;
  std::string vehicle_name;                                   // of its file, for messages
  double voltage = std::numeric_limits<double>::quiet_NaN();  // of the thrusters' supply [V]
};

// By what the noise of a velocity is known.
enum class NoiseSource {
  kLog,              // size and colour are those of the fit's residual
  kLogTakenAsWhite,  // the size alone: the model's file does not hold the colour
  kLimits,           // the limits file says how large it is: white
};

// "log", "log_taken_as_white" or "limits".
std::string_view Name(NoiseSource source);

// The next experiment of several DOFs: docs/plan.md, "Several degrees of freedom".
struct CoupledPlan {
  // False: no command was found that keeps the limits; nothing below is filled in.
  bool IsUsable() const { return message.empty(); }
  std::string message = "PlanCoupledExperiment() was not called.";

  std::vector<WrenchAxis> axes;               // that are commanded
  std::optional<WrenchAllocation> thrusters;  // of them, where the request has a vehicle
  std::vector<WrenchBlock> blocks;
  CoupledCommand command;  // from t = 0 on
  double duration = 0.0;   // [s], of whole cells

  double rate = 0.0;                 // of the velocities [Hz]
  std::array<double, 6> noise = {};  // of one, by Index(Dof) [m/s] or [rad/s]
  // Its colour over samples, phi_1 ... of docs/output_error.md (5); no numbers: white.
  std::array<std::vector<double>, 6> colour;
  std::array<NoiseSource, 6> noise_source = {};

  // The entries of the model that a wrench can tell; `sine`: by one axis after the other.
  std::vector<PlannedParameter> parameters;
  std::vector<std::string> left_out;           // names of the others
  std::vector<PlannedSeparation> separations;  // of the rivals, both ways

  CoupledCommand sine;                 // a sine on one axis after the other
  std::vector<double> sine_amplitude;  // of each axis: the greatest that the limits leave

  double share_breaking = 0.0;       // of the models that the log allows, those that break a limit
  int num_models = 0;                // that this was counted in
  std::vector<double> time;          // of the command and the coast behind it, kCoastAfterwards [s]
  std::array<PlannedBand, 6> speed;  // of modelled DOFs, by Index(Dof)
  std::array<PlannedBand, 3> position;  // from the start: ahead, starboard, down [m]
  double tilt = 0.0;                    // that 95 % of the models stay below [rad]
  PlannedBand heading;  // off that at the start, where it has a limit; else empty [rad]
};

}  // namespace fathom
