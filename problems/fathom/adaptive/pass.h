// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/adaptive/adaptive_identifier.h"
#include "fathom/signal/signals.h"

#include <span>
#include <vector>

namespace fathom {

// The samples of one segment as the identifier takes them: the force is the mean of the held
// command up to the next stamp.
struct PassSegment {
  std::vector<double> time;       // [s]
  std::vector<double> force;      // [N] or [N m]
  std::vector<double> velocity;   // [m/s] or [rad/s]
  double initial_velocity = 0.0;  // of a free run [m/s] or [rad/s]
};

// In time order.
std::vector<PassSegment> PassOver(std::span<const Segment> segments);

// Feeds everything to `identifier` and calls visit() after each sample.
template <typename Visit>
void Feed(const std::vector<PassSegment>& pass, AdaptiveIdentifier* identifier, Visit visit) {
  for (const PassSegment& segment : pass) {
    identifier->StartSegment();
    for (size_t i = 0; i < segment.time.size(); ++i) {
      identifier->Add(segment.time[i], segment.force[i], segment.velocity[i]);
      visit();
    }
  }
}

}  // namespace fathom
