// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/synthesize/experiment/experiment.h"

#include <cstdint>
#include <string>
#include <vector>

namespace fathom {

// When a sensor measures and how many of its measurements arrive.
struct SampleTimes {
  std::vector<double> time;       // since the start [s], strictly increasing, whole microseconds
  std::vector<bool> has_arrived;  // false within a drop-out
  int num_drop_outs = 0;
  int num_lost = 0;
};

// Samples of `duration` seconds on a jittered grid, the first at 0 or just after. `purpose` names
// the streams of random numbers: "velocity".
SampleTimes DrawSampleTimes(const Sampling& sampling,
                            double duration,
                            std::uint64_t seed,
                            const std::string& purpose);

}  // namespace fathom
