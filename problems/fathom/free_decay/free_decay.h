// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/free_decay/decay_motion.h"
#include "fathom/free_decay/decay_options.h"
#include "fathom/free_decay/decay_stretch.h"

#include <array>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// Numbers that were not computed are NaN.
struct FreeDecaySummary {
  static constexpr double kNotComputed = std::numeric_limits<double>::quiet_NaN();

  // True if the search converged, and something decays.
  bool IsUsable() const { return usable; }

  bool usable = false;
  std::string message = "FitFreeDecay() was not called.";

  DecayRates rates = {kNotComputed, kNotComputed, kNotComputed, kNotComputed};
  // In their order, infinite where the data tell nothing. The one of c and d that is no unknown has
  // 0. A rate on its bound 0 has the spread it would have without the bound.
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Constant(kNotComputed);
  std::array<bool, kNumDecayRates> on_bound = {};

  int num_samples = 0;
  double duration = 0.0;      // of all stretches [s]
  double rms = kNotComputed;  // of the residuals, in the unit of the motion
  Eigen::VectorXd residuals;  // simulated minus measured, stretch after stretch
  double largest_speed = kNotComputed, smallest_speed = kNotComputed;  // of the fitted motion
  std::vector<std::string> caveats;  // what the intervals do not say, a sentence each
};

// The rates whose free motion is nearest to the measured one, with a start of its own for each
// stretch: output error with an inertia of 1 and no force. docs/free_decay.md (1) to (4).
//
// Squares first, then Huber's loss at the noise found. The covariance holds for residuals coloured
// like an autoregression. Not usable: too few samples, nothing that decays, or no convergence.
// Throws InputError for options that break their rules.
FreeDecaySummary FitFreeDecay(std::span<const DecayStretch> stretches,
                              const FreeDecayOptions& options = {});

}  // namespace fathom
