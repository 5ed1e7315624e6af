// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/records.h"
#include "fathom/noise/whitener.h"
#include "fathom/signal/excitation.h"
#include "fathom/vehicle/extended_model.h"

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// The data of a fit: records, their simulations, and their bins.
class TrainingData {
 public:
  explicit TrainingData(std::vector<Record> records);

  const std::vector<Record>& records() const { return records_; }
  const std::vector<EffectSimulation>& simulations() const { return simulations_; }
  const Bins& bins() const { return bins_; }
  bool has_displacement() const { return has_displacement_; }

  // States of a record that are free: the velocity, and the position where it is measured.
  int num_states() const { return has_displacement_ ? 2 : 1; }

  // The strongest line of the command that is least of a tone.
  const Tone& command_tone() const { return command_tone_; }

  double longest_duration() const { return longest_duration_; }  // of a record [s]

  // Measured, averaged over the bins.
  const Eigen::VectorXd& measured() const { return measured_; }

  // Simulated, averaged over the bins; nothing if a run diverges.
  std::optional<Eigen::VectorXd> Simulate(const ExtendedModel& model,
                                          std::span<const InitialState> initial) const;

  // The same with its derivatives: columns are the baseline's parameters, the effects', then the
  // free states record by record.
  struct Linearised {
    Eigen::VectorXd simulated;
    RowMajorMatrix jacobian;
  };
  std::optional<Linearised> Linearise(const ExtendedModel& model,
                                      std::span<const InitialState> initial) const;

 private:
  std::vector<Record> records_;
  std::vector<EffectSimulation> simulations_;
  Bins bins_;
  bool has_displacement_ = false;
  Tone command_tone_;
  double longest_duration_ = 0.0;
  Eigen::VectorXd measured_;
};

// A model where its generalised squared error is least.
struct StructureFit {
  bool converged = false;
  ExtendedModel model;
  std::vector<InitialState> initial;

  NoiseModel noise;
  double log_likelihood = -std::numeric_limits<double>::infinity();
  double chi_squared = std::numeric_limits<double>::infinity();  // |W (y - simulated)|^2

  Eigen::VectorXd residual;       // measured - simulated, by bins, not whitened
  RowMajorMatrix jacobian;        // not whitened
  Eigen::MatrixXd covariance;     // of the baseline's and the effects' parameters
  std::vector<bool> is_on_bound;  // of the same
};

// Least generalised squared error from `start` under `whitener`, every parameter within its bounds
// (inertia above 0, dampings at least 0, the effects' own). Levenberg and Marquardt's method on the
// normal equations; parameters that press on a bound are held there and let go again when they no
// longer do, docs/diagnosis.md (3).
//
// Ends when no step promises more than `smallest_share` of what is left of the error (or 0.01).
StructureFit FitStructure(const TrainingData& data,
                          const ExtendedModel& start,
                          std::span<const InitialState> initial,
                          const Whitener& whitener,
                          double smallest_share = 0.0);

// The same with the noise learned along: fit and noise in turns, from `noise`.
StructureFit FitStructureAndNoise(const TrainingData& data,
                                  const ExtendedModel& start,
                                  std::span<const InitialState> initial,
                                  const NoiseModel& noise);

// The same on from a fit whose residual and Jacobian are those of its model, the noise from that.
StructureFit FitStructureAndNoise(const TrainingData& data, const StructureFit& start);

// The baseline from a start near its optimum, with its noise.
StructureFit FitBaseline(const TrainingData& data,
                         const ExtendedModel& start,
                         std::span<const InitialState> initial);

// The noise of a fit's residual, of which nothing else is known.
NoiseModel FirstNoise(const TrainingData& data, const StructureFit& fit);

// White noise as a sensor alone would have it, from the residual's second differences, which
// structure hardly reaches: under it nothing that is missing passes for a disturbance.
NoiseModel SensorNoiseOnly(const TrainingData& data, const Eigen::VectorXd& residual);

// Damping rate of the model about its usual speed [1/s], for NoiseModel.
double DampingRate(const TrainingData& data, const UncoupledModel<double>& model);

}  // namespace fathom
