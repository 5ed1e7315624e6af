// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/data/bins.h"
#include "fathom/diagnosis/data/measured_segments.h"
#include "fathom/noise/noise_model.h"
#include "fathom/noise/whitener.h"
#include "fathom/signal/filters/dominant_tone.h"
#include "fathom/simulate/effect_simulation.h"
#include "fathom/vehicle/extended_model.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// The data of a fit: segments, their simulations, and their bins.
class TrainingData {
 public:
  // `about`: a model near the truth, whose damping tells how easily the vehicle is disturbed from
  // sample to sample; docs/residual_noise.md (3). `least_inertia`: the smallest that a fit may try
  // [kg] or [kg m^2].
  explicit TrainingData(std::vector<MeasuredSegment> segments,
                        const UncoupledModel<double>& about = {},
                        double least_inertia = 0.0);

  const std::vector<MeasuredSegment>& segments() const { return segments_; }
  const Bins& bins() const { return bins_; }

  // Of the bins, with their damping factors.
  const std::vector<NoiseSample>& samples() const { return samples_; }

  // Damping rate of a model about the usual speed of these data [1/s].
  double DampingRate(const UncoupledModel<double>& model) const;

  double least_inertia() const { return least_inertia_; }

  bool has_displacement() const { return has_displacement_; }

  // States of a segment that are free: the velocity, the position where it is measured, and
  // ExcessesOf() the model. In this order.
  int num_states(const ExtendedModel& model) const {
    return (has_displacement_ ? 2 : 1) +
           static_cast<int>(EffectSimulation::ExcessesOf(model).size());
  }

  // The strongest line of the command that is least of a tone.
  const Tone& command_tone() const { return command_tone_; }

  double most_force() const { return most_force_; }  // commanded [N] or [N m]

  // The greatest offset between clocks that these data tell [s]: an eighth of the longest segment,
  // since what is commanded and measured outside of it is not known, and half a period of a command
  // that is a tone alone.
  double most_offset() const;

  double duration() const { return duration_; }  // of all segments [s]

  double longest_duration() const { return longest_duration_; }  // of a segment [s]

  // What was computed on these data and their copies, in steps of integration: one with derivatives
  // counts as six, a look at the likelihood of a noise as one for each bin.
  std::int64_t work() const { return *work_; }
  void CountLikelihoods(int count) const { *work_ += std::int64_t{count} * bins_.size(); }

  // Measured, averaged over the bins.
  const Eigen::VectorXd& measured() const { return measured_; }

  // Simulated, averaged over the bins; nothing if a run diverges.
  std::optional<Eigen::VectorXd> Simulate(const ExtendedModel& model,
                                          std::span<const InitialState> initial) const;

  // The same where only the rows of one log differ from what is known, `elsewhere`; without a name,
  // all are simulated.
  std::optional<Eigen::VectorXd> SimulateLog(const std::string& log,
                                             const ExtendedModel& model,
                                             std::span<const InitialState> initial,
                                             Eigen::VectorXd elsewhere) const;

  // The same with its derivatives: columns are the baseline's parameters, the effects', then the
  // free states segment by segment.
  struct Linearised {
    Eigen::VectorXd simulated;
    RowMajorMatrix jacobian;
  };
  std::optional<Linearised> Linearise(const ExtendedModel& model,
                                      std::span<const InitialState> initial) const;

 private:
  void SetDamping(const UncoupledModel<double>& about);

  std::vector<MeasuredSegment> segments_;
  std::vector<EffectSimulation> simulations_;
  Bins bins_;
  std::vector<NoiseSample> samples_;
  double usual_speed_ = 0.0;  // [m/s] or [rad/s]
  double least_inertia_ = 0.0;
  bool has_displacement_ = false;
  Tone command_tone_;
  double most_force_ = 0.0;
  double duration_ = 0.0;
  double longest_duration_ = 0.0;
  Eigen::VectorXd measured_;
  std::shared_ptr<std::atomic<std::int64_t>> work_ = std::make_shared<std::atomic<std::int64_t>>(0);
};

}  // namespace fathom
