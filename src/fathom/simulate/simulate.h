// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/held_command.h"
#include "fathom/vehicle/uncoupled_model.h"

#include <span>
#include <vector>

namespace fathom {

// Where a simulation starts: at the first output stamp.
struct InitialState {
  double velocity = 0.0;  // [m/s] or [rad/s]
  double position = 0.0;  // [m] or [rad]

  // What a sensor with a memory (`sensor_lag`) shows beyond what it would show without one, [m/s]
  // or [rad/s]: its own past, which is nowhere else. No other model asks for it.
  double reading_excess = 0.0;

  // What the water remembers of the speed (`fluid_memory`) beyond the speed at the start, [m/s] or
  // [rad/s]: its past too. No other model asks for it.
  double memory_excess = 0.0;
};

// A model over one log's command, integrated from output stamp to output stamp.
//
//   dv/dt = a(v, tau(t); p),   dx/dt = v                       docs/models.md (1)
//
// The classical Runge-Kutta scheme of order four, stepping at every stamp of the command and every
// output stamp, so that no step crosses a change of the held command; a step longer than a tenth of
// the damping's time constant is divided. Stamps are laid out once; running allocates nothing.
class Simulation {
 public:
  // Columns of the sensitivities: the four parameters in the order of kParameterInfo, then the
  // initial velocity. (The initial position only shifts the position: derivative 1, else 0.)
  static constexpr int kNumSensitivities = 5;

  // `output_time` [s] strictly increasing. `command` before its first stamp is 0.
  Simulation(const HeldCommand& command, std::span<const double> output_time);

  int num_outputs() const { return num_outputs_; }

  // Fills velocity[i] and, unless it is empty, position[i] at output stamp i. Returns false if the
  // state leaves the finite numbers or the model is too stiff to integrate (a damping time constant
  // below a hundredth of a step); the outputs then mean nothing.
  bool Run(const UncoupledModel<double>& model,
           const InitialState& initial,
           std::span<double> velocity,
           std::span<double> position) const;

  // The same with derivatives; row-major, num_outputs() x kNumSensitivities. Empty spans are not
  // filled.
  bool RunWithSensitivities(const UncoupledModel<double>& model,
                            const InitialState& initial,
                            std::span<double> velocity,
                            std::span<double> position,
                            std::span<double> velocity_sensitivity,
                            std::span<double> position_sensitivity) const;

 private:
  struct Step {
    double duration;  // [s]
    double force;     // [N] or [N m], held over the step
    int output;       // index of the output stamp at its end, or -1
  };
  int num_outputs_ = 0;
  std::vector<Step> steps_;
};

}  // namespace fathom
