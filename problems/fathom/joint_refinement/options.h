// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/uncoupled_model.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace fathom {

struct JointOptions {
  // Where the search starts. Absent: output error on the displacement of the first guesses.
  std::optional<UncoupledModel<double>> initial_guess = {};

  // True: no model. The excited DOF moves as the corners say, and nobody reads the command; of the
  // summary only the poses and the processes then mean something. docs/joint_refinement.md,
  // "Without a model"
  bool moves_freely = false;

  // Standard deviations of what is known beforehand; 0: not estimated. Infinite: nothing is known.
  double clock_offset_std = 0.0;    // of each segment [s]
  double size_scale_std = 0.0;      // of the markers' sides, no unit
  double mount_position_std = 0.0;  // of the camera in the body [m]
  double mount_angle_std = 0.0;     // [rad]

  // Squared norm of a detection's eight whitened residuals from which on it counts by its
  // logarithm. Above 0. 26.1 is passed by one good detection in a thousand.
  double loss_limit = 26.1;

  // Above 0.
  int max_iterations = 50;

  // How often the processes are estimated about the refined trajectory, at most. At least 1.
  int max_rounds = 6;

  // Called before each round with its number from 1 on; may be empty.
  std::function<void(int round, int max_rounds)> on_round = {};

  // One line for each rule that is broken; empty if these options can be used.
  std::vector<std::string> Problems() const;
};

}  // namespace fathom
