// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/held_command.h"

#include <limits>

namespace fathom {

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

// The same over all of its stamps; no tone for fewer than two.
Tone DominantTone(const HeldCommand& command);

}  // namespace fathom
