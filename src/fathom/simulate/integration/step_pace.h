// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/effect_inputs.h"
#include "fathom/simulate/integration/instants.h"
#include "fathom/simulate/integration/scalar_model.h"
#include "fathom/simulate/integration/water_integrator.h"

#include <limits>

namespace fathom {

// How long the steps of a run may be. It computes without derivatives: a run with them takes the
// steps of the one without, and pays for the choice no more than that one does.
class StepPace {
 public:
  // Both must outlive this.
  StepPace(const EffectInputs& inputs, const ScalarModel<double>& model);
  StepPace(const StepPace&) = delete;
  StepPace& operator=(const StepPace&) = delete;

  // How a run may go on from a state.
  struct Pace {
    double longest = 0.0;   // [s]; 0 where the baseline has run away
    double rate = 0.0;      // the quickest [1/s]
    bool is_stiff = false;  // the classical scheme's would be far shorter: one that is checked
  };

  // From `state` at `s` [s] on the command's clock, while `command` is held: by the water's
  // quickest rate now and about rest, where friction turns, and by what swings. No step longer than
  // `wanted` [s] is asked for.
  Pace From(const RunState<double>& state, double command, double s, double wanted);

  // How fast a small difference in speed grows, below 0 shrinks [1/s], at `state` and `speed`.
  double SpeedRate(const RunState<double>& state, double speed, double command, double s);

  // Whether a stiff step of `h` [s] from `before` to `after` was short enough for what changes on
  // its way, also where it passes rest, or would at the `slope` that it began with [m/s^2] or
  // [rad/s^2]. `rate`: SpeedRate() at `before`.
  bool IsShortEnough(const RunState<double>& before,
                     double slope,
                     const RunState<double>& after,
                     double command,
                     double s,
                     double h,
                     double rate);

 private:
  double WaterRate(const RunState<double>& state, double command, double s, double wanted);
  double SwingRate(const RunState<double>& state, double command, double s);

  const ScalarModel<double>& model_;
  Instants<double> instants_;
  WaterIntegrator<double> water_;
  const bool acts_on_water_;
  const double longest_;  // [s], however slow the water is
  RunState<double> probe_;
  double water_rate_ = std::numeric_limits<double>::infinity();  // when last looked at [1/s]
  int since_look_ = 0;                                           // steps
};

}  // namespace fathom
