// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/coupled/manoeuvre.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace fathom {

// What a helmsman sees, to starboard.
struct HelmView {
  double time = 0.0;     // [s]
  double ahead = 0.0;    // [m/s]
  double heading = 0.0;  // unwrapped [rad]
  double rate = 0.0;     // of the yaw [rad/s]
};

// A turn that has become steady, to starboard.
struct SteadyTurn {
  double angle = 0.0;  // of the rudder [rad]
  double rate = 0.0;   // of the yaw [rad/s]
};

// Gives the orders of a manoeuvre and says when it is over. An order of a spiral or a pull-out
// stands until the yaw rate changes by less than a thousandth of the largest one within `settle`.
class Helmsman {
 public:
  // `step`: from one look to the next [s]. `delay`: from the heading that asks for an order to the
  // order [s]. `settle` [s], `longest` that such an order stands [s].
  Helmsman(const Manoeuvre& manoeuvre, double step, double delay, double settle, double longest);

  // To be called step by step.
  void See(const HelmView& view);

  double Order() const { return order_; }           // to starboard [rad]
  double NextOrder() const { return next_order_; }  // the one that follows
  double NextTime() const { return next_time_; }    // and when [s]; infinite: not known yet
  bool IsDone() const { return is_done_; }
  const std::vector<SteadyTurn>& steady() const { return steady_; }

 private:
  void SeeZigzag(const HelmView& view);
  double WhenReached(const HelmView& view) const;
  void SeeHeld(const HelmView& view);
  bool IsSteady(double time) const;

  Manoeuvre manoeuvre_;
  double step_, delay_, settle_, longest_;
  std::vector<double> held_ = {};  // orders of a spiral or a pull-out
  std::size_t num_held_ = 0;
  double since_ = 0.0, largest_rate_ = 0.0;
  std::vector<HelmView> views_ = {};
  std::vector<SteadyTurn> steady_ = {};
  double order_ = 0.0, next_order_ = 0.0;
  double next_time_ = std::numeric_limits<double>::infinity();
  int num_turned_ = 0;
  double side_ = 1.0;
  bool is_done_ = false;
};

// Orders of a spiral or a pull-out, in turn [rad]; none of others. A spiral goes by 5 degrees,
// within 10 degrees of midships by 1 degree.
std::vector<double> HeldOrders(const Manoeuvre& manoeuvre);

// Whether a stop that began at a speed is over: no way ahead, or with the thrust off 5 % of it.
bool HasStopped(const Manoeuvre& manoeuvre, double ahead_at_begin, double ahead);

}  // namespace fathom
