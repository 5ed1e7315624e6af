// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/noise/noise_model.h"

#include <span>
#include <vector>

#include <Eigen/Core>

namespace fathom {

enum class NoiseComponent { kVelocityColour, kDisplacementColour, kDisturbance };

// Which channels there are, how long and how dense the record is: what bounds a noise model.
struct NoiseSampling {
  explicit NoiseSampling(std::span<const NoiseSample> samples);

  bool has_velocity = false, has_displacement = false;
  double longest_segment = 0.0;  // [s]
  double median_step = 0.0;      // between samples of one channel [s]
};

// The parameters of a noise model with given components as a vector, but for one common factor on
// all standard deviations, docs/residual_noise.md (11): the logarithms of
//
//   white_x / white_v                         where both channels are there
//   c / white, time of c                      for coloured noise, white of its channel
//   std of v' / white_v, tau                  for a disturbance; white_x [1/s] without velocity
class NoiseStructure {
 public:
  NoiseStructure(const NoiseSampling& sampling,
                 std::vector<NoiseComponent> components,
                 double damping_rate,
                 double longest_time);

  const std::vector<NoiseComponent>& components() const { return components_; }
  int num_parameters() const { return static_cast<int>(lower_.size()); }

  // Logarithms of the least and greatest values.
  const Eigen::VectorXd& lower() const { return lower_; }
  const Eigen::VectorXd& upper() const { return upper_; }

  // The model of a vector, its reference white noise having standard deviation 1.
  NoiseModel Model(const Eigen::VectorXd& parameters) const;

  // The vector of a model, within the bounds.
  Eigen::VectorXd Parameters(const NoiseModel& model) const;

 private:
  void AddBounds(double least, double greatest);

  NoiseSampling sampling_;
  std::vector<NoiseComponent> components_;
  double damping_rate_;
  Eigen::VectorXd lower_, upper_;
};

// The model with all standard deviations multiplied.
NoiseModel Scaled(NoiseModel model, double factor);

}  // namespace fathom
