// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/adaptive/adaptive_identifier.h"
#include "fathom/adaptive/gains.h"
#include "fathom/signal/signals.h"
#include "fathom/vehicle/parameters.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <limits>
#include <span>
#include <string>
#include <vector>

namespace fathom {

// What FitAdaptive found. Numbers that were not computed are NaN.
struct AdaptiveSummary {
  bool usable = false;
  std::string message = "FitAdaptive was not called.";

  UncoupledModel<double> model{std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::quiet_NaN()};

  // Scatter of the estimate over the last part of the pass, in the order of kParameterInfo.
  ParameterCovariance covariance =
      ParameterCovariance::Constant(std::numeric_limits<double>::quiet_NaN());

  AdaptiveGains gains;  // that were used
  int num_samples = 0;
  std::vector<std::string> caveats;  // what the intervals do not cover, a sentence each

  bool IsUsable() const { return usable; }
};

// The adaptive identifier (the paper's Eqs. 7 and 8) in one pass over all `segments` in time order.
// The estimate is carried from segment to segment; the estimated velocity starts anew in each.
//
// Without gains in the options they come from ChooseGains on the same segments. Not usable: the
// law diverged, or its final inertia means nothing. Throws InputError for options that break their
// rules.
AdaptiveSummary FitAdaptive(std::span<const Segment> segments, const AdaptiveOptions& options = {});

}  // namespace fathom
