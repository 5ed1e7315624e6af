// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/findings/finding.h"
#include "fathom/log/held_command.h"
#include "fathom/signal/segment.h"

#include <optional>
#include <span>
#include <vector>

namespace fathom {

// By how much the motion is later than the command says.
struct CommandDelay {
  double delay = 0.0;     // [s]; negative: the motion comes before its command
  double evidence = 0.0;  // how many times more likely than none, as a natural logarithm
};

// The clock of the command against that of the motion, up to 10 s either way, and up to 60 s where
// no nearer one makes the command act: over windows of a second the change of the momentum is what
// force, damping and buoyancy have done meanwhile,
//
//   v(t + W) - v(t) = a I_F(t - d) - b I_v - c I_v|v| + e W                  docs/findings.md (6)
//
//   I_x   integral of x over the window
//   d     the delay: the one that leaves least, in steps of 0.05 s, beyond 10 s of 0.25 s
//
// Nothing unless that one is e^10 times as likely as none, the force then explains a quarter of
// what the other terms leave, and the motion follows it (a > 0). A periodic command tells no delay
// from one that is a period longer: then nothing too.
//
// `command`: of the whole log. Segments shorter than 20 s are left out.
std::optional<CommandDelay> FindCommandDelay(const HeldCommand& command,
                                             std::span<const Segment> segments);

// What FindCommandDelay() compares: at each delay the correlation of the change of the velocity and
// the impulse of the command, both without what the other terms of (6) explain.
struct DelayCurve {
  std::vector<double> delay;        // [s]
  std::vector<double> correlation;  // -1 to 1
};
DelayCurve CommandDelayCurve(const HeldCommand& command, std::span<const Segment> segments);

// As a finding `command_delay`: a warning if the motion comes first by over 0.2 s, or late by over
// a second; a note if it is late by over 0.3 s, which thrusters and filters may explain.
std::optional<Finding> CheckCommandClock(const HeldCommand& command,
                                         std::span<const Segment> segments);

}  // namespace fathom
