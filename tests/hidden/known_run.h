// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/log.h"
#include "fathom/noise/noise_model.h"
#include "fathom/noise/whitener.h"
#include "fathom/simulate/effect_simulation.h"

#include <memory>
#include <vector>

#include <Eigen/Core>

namespace fathom::hidden {

// What the diagnosis is not told about the measurement of one DOF.
struct KnownNoise {
  NoiseModel model;
  std::vector<double> outlier_stamps;  // of velocities that mean nothing, log time [s]
  bool use_poses = false;              // the displacement of the poses is that along the DOF
};

// One DOF over an interval of a log, with the noise that is known to be in it.
class KnownRun {
 public:
  // `from` and `to` in log time [s]. CHECKs that samples are left.
  KnownRun(const Log& log, Dof dof, double from, double to, const KnownNoise& noise);

  int num_samples() const { return static_cast<int>(samples_.size()); }
  bool has_displacement() const { return !simulation_->stamps().displacement.empty(); }

  // Measured less simulated, in order of samples, whitened. False if the simulation diverges.
  bool Residual(const ExtendedModel& model,
                const InitialState& initial,
                Eigen::VectorXd* residual) const;

  // The same with the derivatives of the simulation (not of the residual), whitened too; columns as
  // EffectOutputs has them.
  bool Linearise(const ExtendedModel& model,
                 const InitialState& initial,
                 Eigen::VectorXd* residual,
                 RowMajorMatrix* sensitivity) const;

  // Columns of any functions of the log time at the velocity's stamps (0 at displacements),
  // whitened: f(t, column).
  template <typename Function>
  RowMajorMatrix WhitenedColumns(int num_columns, const Function& f) const {
    RowMajorMatrix columns = RowMajorMatrix::Zero(num_samples(), num_columns);
    for (int i = 0; i < num_samples(); ++i) {
      if (samples_[i].channel != NoiseChannel::kVelocity) continue;
      for (int j = 0; j < num_columns; ++j) columns(i, j) = f(samples_[i].time, j);
    }
    whitener_->Apply(columns, columns);
    return columns;
  }

  // From now on, as if this noiseless run had been measured. False if the simulation diverges.
  bool Pretend(const ExtendedModel& model, const InitialState& initial);

  // Mean absolute error of the simulated velocity over the mean absolute velocity, not whitened.
  double Nmae(const ExtendedModel& model, const InitialState& initial) const;

  // Where a run starts that nothing is known about.
  InitialState FirstGuess() const { return first_guess_; }

  double start() const { return simulation_->stamps().start; }
  double end() const { return samples_.back().time; }
  double time_zero() const { return inputs_->command.time.front(); }  // first command [s]
  const EffectInputs& inputs() const { return *inputs_; }

 private:
  std::unique_ptr<EffectInputs> inputs_;
  std::unique_ptr<EffectSimulation> simulation_;
  std::vector<NoiseSample> samples_;
  std::vector<double> measured_;  // of each sample
  std::vector<int> row_;          // of each sample in its channel's outputs
  std::unique_ptr<Whitener> whitener_;
  InitialState first_guess_;
};

// Streams of a log as simulations with effects take them, as they were measured.
EffectInputs UnsmoothedInputsOf(const Log& log, Dof dof);

}  // namespace fathom::hidden
