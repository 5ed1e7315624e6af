// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/adaptive/adaptive_follower.h"

#include "fathom/adaptive/usable_estimate.h"
#include "fathom/signal/signals.h"
#include "fathom/signal/split_at_gaps.h"

#include <utility>

namespace fathom {

AdaptiveFollower::AdaptiveFollower(const AdaptiveOptions& options) : identifier_(options) {}

AdaptiveFollower::AdaptiveFollower(const AdaptiveOptions& options,
                                   const AdaptiveState& state,
                                   RecentScatter scatter)
    : identifier_(options, state), scatter_(std::move(scatter)) {}

FollowedEstimate AdaptiveFollower::Add(double t, double force, double velocity) {
  if (t - identifier_.state().t > kLongestGap) identifier_.StartSegment();
  identifier_.Add(t, force, velocity);
  FollowedEstimate estimate;
  estimate.t = t;
  estimate.model = identifier_.Estimate();
  if (!identifier_.IsFinite()) return estimate;
  const ParameterVector now = ToVector(estimate.model);
  scatter_.Add(now);
  if (identifier_.num_samples() < static_cast<long>(kFewestOfSegment)) return estimate;
  estimate.std = scatter_.StdAbout(now);
  estimate.usable = WhyUnusable(estimate.model, estimate.std[kInertia]).empty();
  return estimate;
}

}  // namespace fathom
