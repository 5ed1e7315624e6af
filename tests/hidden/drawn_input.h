// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/synthesize/experiment/input_signal.h"

#include <cstdint>
#include <string>

namespace fathom::hidden {

// A force over time of amplitude about 1.
struct DrawnInput {
  std::string kind;  // "multisine", "chirp", "steps", "prbs", "pilot" or "sine"
  InputSignal input;
};

// `time_constant`: the vehicle's [s]; inputs about as quick as it.
DrawnInput DrawInput(double duration,
                     double rate,
                     double time_constant,
                     std::uint64_t seed,
                     const std::string& purpose);

void Scale(InputSignal& input, double factor);

}  // namespace fathom::hidden
