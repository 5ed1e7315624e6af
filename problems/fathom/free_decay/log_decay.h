// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/base/time_interval.h"
#include "fathom/findings/finding.h"
#include "fathom/free_decay/free_decay.h"
#include "fathom/log/log.h"
#include "fathom/signal/sources/source.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fathom {

// Whether nothing in the log drives this DOF: it has no command at all, or one along the DOF that
// is 0 throughout.
bool IsFreeDecay(const Log& log, Dof dof);

// Whether nothing drives any of the logs along this DOF. One whose command is 0 throughout may
// stand among driven ones, one without a command may not: throws InputError then.
bool AreFreeDecays(std::span<const Log> logs, Dof dof);

struct LogDecayOptions {
  std::optional<Dof> dof = {};        // absent: the only one that each log names
  std::optional<Source> source = {};  // absent: the best that each log has
  // Nothing before it is taken [s]; below 1e6 it counts from the first sample of a log whose stamps
  // are epoch seconds, as HoldOut() has it.
  std::optional<double> from = {};
  FreeDecayOptions fit = {};  // its output and stiffness follow the logs
};

// The free decay of one DOF of a log, or of several together.
struct LogDecay {
  Dof dof = Dof::kSurge;
  Source source = Source::kPoseEstimator;
  DecayOutput output = DecayOutput::kVelocity;
  bool has_stiffness = false;
  FreeDecaySummary summary;
  std::vector<TimeInterval> stretches;  // that were fitted, in log time
  std::vector<DecayStretch> measured;   // the same, as summary.residuals has them
  std::vector<std::string> notes;       // how they were chosen, and what was left out

  std::optional<double> inertia;  // with the water's share, of the vehicle file [kg] or [kg m^2]
  std::optional<double>
      dry_mass;  // where that is all that is known, of a DOF that moves along [kg]
};

// "10.2 to 22.0 s after its first sample": where a stretch lies in a log of such a first stamp,
// which is left out where stamps do not count from an epoch.
std::string TimesOf(const TimeInterval& time, double first);

// Which part of a log is taken: with a command along the DOF, the stretches where it is 0; without
// one, or with one that is 0 throughout, all from options.from on, else the longest stretch over
// which the motion decays. Held-out data are left out. Throws InputError if the logs lack what is
// asked for; a fit that did not work does not throw.
LogDecay FitLogDecay(std::span<const Log> logs, const LogDecayOptions& options = {});

// What the checks of stamps and motion say of the logs of a decay, warnings first.
std::vector<Finding> FindingsOn(std::span<const Log> logs, const LogDecay& decay);

}  // namespace fathom
