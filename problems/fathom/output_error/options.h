// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/output_error/offset_sharing.h"
#include "fathom/output_error/shooting_window.h"
#include "fathom/output_error/weighting.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <optional>
#include <string>
#include <vector>

namespace fathom {

struct OutputErrorOptions {
  // Where the search starts. Absent: the better of least squares and, where that is poor, the
  // adaptive law, by their free-running error on the same data.
  std::optional<UncoupledModel<double>> initial_guess;

  // What the simulation is compared with; the position needs poses.
  FittedOutput output = FittedOutput::kVelocity;

  // Which squares count.
  Weighting weighting = Weighting::kPlain;

  OffsetSharing offsets = {};

  // Residuals beyond this many robust standard deviations count linearly, not squared. Above 0;
  // infinite: plain least squares.
  double huber_k = 3.0;

  // A segment longer than this is cut into windows of this length, each with an initial state of
  // its own, tied to its neighbour [s]. Above 0; infinite: single shooting.
  double shooting_window = 600.0;

  // How exactly a window must meet its neighbour: standard deviation of the jump, in standard
  // deviations of the measurement. Above 0.
  double continuity = 1e-3;

  // Above 0.
  int max_iterations = 100;

  // One line for each rule that is broken; empty if these options can be used.
  std::vector<std::string> Problems() const;
};

}  // namespace fathom
