// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/output_error/summary.h"
#include "fathom/signal/segment.h"

#include <span>
#include <string>

namespace fathom {

// Decides whether the data determine the model, and says in words what the intervals do not: which
// parameter this log cannot tell, why, and which experiment would. `output`: what was fitted. Reads
// summary->evidence, model and on_bound; fills determined, message, caveats and delay_is_open.
void DescribeEvidence(std::span<const Segment> segments,
                      FittedOutput output,
                      OutputErrorSummary* summary);

// That the data hardly tell a damping, where half its 95 % interval is more than its value; empty
// where it is not. `std`: its standard deviation.
std::string CaveatOnDamping(int parameter, double value, double std);

// That inertia, damping and a delay of the command cannot be told apart; or, where the command is
// more than a single sine, how much less is known of the inertia with the delay unknown. Empty
// where that is still 1 %: such a log tells the delay as well.
struct DelayDoubt {
  double inertia = 0.0;             // found without a delay [kg] or [kg m^2]
  double inertia_per_second = 0.0;  // what a delay of a second would change [kg/s] or [kg m^2/s]
  double linear_damping_per_second = 0.0;  // likewise
  double half_width = 0.0;                 // of the inertia's 95 % interval where there is no delay
  double half_width_with_delay = 0.0;      // where it is unknown; infinite: nothing is known
};
// `command`: of the longest run, HeldCommand::Between() its first and last sample.
std::string CaveatOnDelay(const HeldCommand& command, const DelayDoubt& doubt);

// A parameter that loses this much of its share once a delay is admitted cannot be told from one.
// Measured: single sines lose three quarters, steps and several tones less than a third.
inline constexpr double kLostToDelay = 0.5;

// What to say of a damping that ended on its bound 0; `half_width` of the 95 % interval that it
// would have without the bound.
std::string CaveatOnBound(int parameter, double half_width);

}  // namespace fathom
