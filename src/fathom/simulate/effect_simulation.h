// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/effect_inputs.h"
#include "fathom/simulate/output_stamps.h"
#include "fathom/simulate/simulate.h"
#include "fathom/vehicle/extended_model.h"

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// A part of the state at the start that only some models have.
using Excess = double InitialState::*;

using SensitivityMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// What the sensors would show.
struct EffectOutputs {
  std::vector<double> velocity;      // at OutputStamps::velocity [m/s] or [rad/s]
  std::vector<double> displacement;  // at OutputStamps::displacement [m] or [rad]
  int num_steps = 0;                 // of the integration, also of one that failed

  // A row for each output. Columns: the baseline's parameters in the order of kParameterInfo, the
  // initial velocity, the initial position, the effects' parameters in their order, and the
  // ExcessesOf() the model. Empty unless asked for.
  SensitivityMatrix velocity_sensitivity;
  SensitivityMatrix displacement_sensitivity;
};

// The baseline model and any effects over one log's command; docs/effects.md.
//
// Classical Runge-Kutta between the command's stamps, in steps of at most 0.2 s and of a quarter of
// the water's quickest time constant; the force of a step is its mean, which lag and slew limit
// know exactly. Outputs lie on the cubic through both ends of their step, so that stamps can be
// moved (`time_offset`, `sensor_clock_offset`) and differentiated by how far. `time` in the
// effects' equations counts from the first command sample. What thrusters and water remember at the
// start comes from the command and the measured velocity of the 60 s before it; where nothing was
// measured before, the water is in balance with the initial velocity.
class EffectSimulation {
 public:
  // Columns before those of the effects.
  static constexpr int kFirstEffectColumn = 6;
  static constexpr int kInitialVelocityColumn = 4;
  static constexpr int kInitialPositionColumn = 5;

  // The most parameters that all effects of a model may have together, excesses counted along.
  static constexpr int kMostEffectParameters = 10;

  static int NumColumns(const ExtendedModel& model);

  // Of the baseline and the effects: columns less those of the state at the start.
  static int NumParameters(const ExtendedModel& model);

  // True if the sensor's reading has a memory of its own.
  static bool HasReadingMemory(const ExtendedModel& model);

  // What the model asks of InitialState beside velocity and position, in the order of the last
  // columns: of the reading, of the water's memory, or both.
  static std::vector<Excess> ExcessesOf(const ExtendedModel& model);

  // `inputs` must outlive this. `stamps.velocity` or `stamps.displacement` may be empty, not both.
  EffectSimulation(const EffectInputs* inputs, OutputStamps stamps);

  const OutputStamps& stamps() const { return stamps_; }

  // Returns false if the state leaves the finite numbers or is too stiff to integrate; the outputs
  // then mean nothing. `initial` holds at stamps().start.
  bool Run(const ExtendedModel& model, const InitialState& initial, EffectOutputs* outputs) const;
  bool RunWithSensitivities(const ExtendedModel& model,
                            const InitialState& initial,
                            EffectOutputs* outputs) const;

 private:
  const EffectInputs* inputs_;
  OutputStamps stamps_;
};

}  // namespace fathom
