// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/adaptive/adaptive_identifier.h"
#include "fathom/adaptive/adaptive_state.h"
#include "fathom/adaptive/recent_scatter.h"
#include "fathom/vehicle/parameters.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <limits>

namespace fathom {

// What the adaptive law says behind one sample.
struct FollowedEstimate {
  double t = 0.0;                // stamp of the sample [s]
  UncoupledModel<double> model;  // NaN once the law has diverged

  // Scatter of the estimate over the last third of the samples so far, in the order of
  // kParameterInfo; no standard error: docs/adaptive.md, "Intervals". NaN while there are fewer
  // than kFewestOfSegment samples, and once the law has diverged.
  ParameterVector std = ParameterVector::Constant(std::numeric_limits<double>::quiet_NaN());

  // Whether FitAdaptive would call a pass that ends here usable, but for its caveats.
  bool usable = false;
};

// Follows a stream by the adaptive law: AdaptiveIdentifier with the scatter of its estimates and
// with a new segment behind each silence of over kLongestGap, as FitAdaptive has them. Its memory
// does not grow with the stream.
//
// On the samples of one log, whose force is held from each stamp to the next, it ends at the
// numbers of FitAdaptive with the same options. Only pieces of fewer than kFewestOfSegment samples
// between silences differ: they are left out there, which a stream cannot know.
class AdaptiveFollower {
 public:
  // Throws InputError as AdaptiveIdentifier does.
  explicit AdaptiveFollower(const AdaptiveOptions& options);

  // Goes on where another one was.
  AdaptiveFollower(const AdaptiveOptions& options,
                   const AdaptiveState& state,
                   RecentScatter scatter);

  // One sample, as AdaptiveIdentifier::Add takes it.
  FollowedEstimate Add(double t, double force, double velocity);

  AdaptiveState state() const { return identifier_.state(); }
  const RecentScatter& scatter() const { return scatter_; }

  // False once the law has diverged.
  bool IsFinite() const { return identifier_.IsFinite(); }

 private:
  AdaptiveIdentifier identifier_;
  RecentScatter scatter_;
};

}  // namespace fathom
