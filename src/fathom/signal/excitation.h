// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/held_command.h"

#include <limits>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// How well a log tells one parameter from all others.
struct ParameterExcitation {
  std::string name;

  // Of the column's length, what is left after taking out everything that the other columns can
  // stand for: 1 tells it apart fully, 0 not at all. NaN for a column of zeros.
  double surviving_share = std::numeric_limits<double>::quiet_NaN();
};

struct Excitation {
  // Largest over smallest singular value of the columns scaled to length 1; infinite if they are
  // linearly dependent to rounding.
  double condition_number = std::numeric_limits<double>::quiet_NaN();

  std::vector<ParameterExcitation> parameters;  // in the order of the columns
};

// From a matrix with a row for each sample and a column for each parameter: the regressor of least
// squares, or the sensitivities of a simulation. docs/signal.md (8).
Excitation ExcitationOf(const Eigen::MatrixXd& sensitivity, const std::vector<std::string>& names);

// The strongest line of a command.
struct Tone {
  double frequency = std::numeric_limits<double>::quiet_NaN();  // [rad/s]
  double share = 0.0;                                           // of the command's variance, 0 to 1

  // The command is this line and little else.
  bool IsAlone() const { return share > 0.9; }
};

// By least squares on a grid of frequencies from half a period per duration upwards, then refined;
// docs/signal.md (9). The command is taken over [first stamp, first stamp + duration]. No tone
// (NaN, 0) for a constant command.
Tone DominantTone(const HeldCommand& command, double duration);

}  // namespace fathom
