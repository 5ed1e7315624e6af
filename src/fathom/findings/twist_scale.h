// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/findings/twin_motion.h"

#include <span>
#include <string>
#include <vector>

namespace fathom {

// How many times the velocity of the poses a column of velocity.csv is, both about their means, and
// its 95 % interval; docs/findings.md (11). Not finite where the log is too short.
struct TwistScale {
  double factor = 0.0, half_width = 0.0;
};

// Of the twist `delay` [s] later.
TwistScale TwistScaleOf(const TwinMotion& motion, double delay);

// "1.98 (1.96 to 2.01)"; the factor alone where the interval is not finite.
std::string FormatTwistScale(const TwistScale& scale);

// The instrument of a noisy curve: itself a while before plus itself a while later, by that one of
// 1.25, 2 and 3 windows of its filter at which it is most like itself. It moves as the curve does,
// and its noise is another. NaN near the ends.
std::vector<double> InstrumentOf(std::span<const double> time,
                                 std::span<const double> values,
                                 double window);

}  // namespace fathom
