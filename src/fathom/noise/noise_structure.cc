// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/noise/noise_structure.h"

#include "fathom/base/median.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glog/logging.h>

namespace fathom {
namespace {

// Noise weaker than this share of the white noise is as good as none, and white noise weaker than
// this share of coloured noise likewise.
constexpr double kLeastRatio = 1e-3;
// Of displacement to velocity noise: centimetres to metres per second, in any unit a log may have.
constexpr double kLeastWhiteRatio = 1e-6;

}  // namespace

NoiseSampling::NoiseSampling(std::span<const NoiseSample> samples) {
  std::vector<double> steps;
  double start = 0.0;
  std::array<const NoiseSample*, 2> last = {nullptr, nullptr};
  for (const NoiseSample& sample : samples) {
    const bool is_velocity = sample.channel == NoiseChannel::kVelocity;
    (is_velocity ? has_velocity : has_displacement) = true;
    if (&sample == samples.data() || sample.segment != (&sample - 1)->segment) start = sample.time;
    longest_segment = std::max(longest_segment, sample.time - start);
    const NoiseSample*& before = last[is_velocity ? 0 : 1];
    if (before != nullptr && before->segment == sample.segment && sample.time > before->time) {
      steps.push_back(sample.time - before->time);
    }
    before = &sample;
  }
  if (!steps.empty()) median_step = Median(std::move(steps));
}

NoiseStructure::NoiseStructure(const NoiseSampling& sampling,
                               std::vector<NoiseComponent> components,
                               double damping_rate,
                               double longest_time)
    : sampling_(sampling), components_(std::move(components)), damping_rate_(damping_rate) {
  if (sampling.has_velocity && sampling.has_displacement) {
    AddBounds(kLeastWhiteRatio, 1.0 / kLeastWhiteRatio);
  }
  for (size_t i = 0; i < components_.size(); ++i) {
    AddBounds(kLeastRatio, 1.0 / kLeastRatio);
    AddBounds(sampling.median_step,
              std::max(2.0 * sampling.median_step, longest_time * sampling.longest_segment));
  }
}

void NoiseStructure::AddBounds(double least, double greatest) {
  const Eigen::Index i = lower_.size();
  lower_.conservativeResize(i + 1);
  upper_.conservativeResize(i + 1);
  lower_[i] = std::log(least);
  upper_[i] = std::log(greatest);
}

NoiseModel NoiseStructure::Model(const Eigen::VectorXd& parameters) const {
  CHECK_EQ(parameters.size(), num_parameters());
  NoiseModel model;
  model.damping_rate = damping_rate_;
  Eigen::Index i = 0;
  if (sampling_.has_velocity) model.velocity.white_std = 1.0;
  if (sampling_.has_displacement) {
    model.displacement.white_std = sampling_.has_velocity ? std::exp(parameters[i++]) : 1.0;
  }
  for (const NoiseComponent component : components_) {
    const double ratio = std::exp(parameters[i++]);
    const double time = std::exp(parameters[i++]);
    switch (component) {
      case NoiseComponent::kVelocityColour:
        model.velocity.coloured = {ratio * model.velocity.white_std, time};
        break;
      case NoiseComponent::kDisplacementColour:
        model.displacement.coloured = {ratio * model.displacement.white_std, time};
        break;
      case NoiseComponent::kDisturbance:
        model.disturbance = {1.0, time};
        model.disturbance.std = ratio / model.DisturbedVelocityStd();
        break;
    }
  }
  return model;
}

Eigen::VectorXd NoiseStructure::Parameters(const NoiseModel& model) const {
  Eigen::VectorXd parameters(num_parameters());
  Eigen::Index i = 0;
  const double white_v = model.velocity.white_std, white_x = model.displacement.white_std;
  if (sampling_.has_velocity && sampling_.has_displacement) {
    parameters[i++] = std::log(white_x / white_v);
  }
  const auto add = [&](double ratio, double time) {
    parameters[i++] = std::log(ratio);
    parameters[i++] = std::log(time);
  };
  for (const NoiseComponent component : components_) {
    switch (component) {
      case NoiseComponent::kVelocityColour:
        add(model.velocity.coloured.std / white_v, model.velocity.coloured.time);
        break;
      case NoiseComponent::kDisplacementColour:
        add(model.displacement.coloured.std / white_x, model.displacement.coloured.time);
        break;
      case NoiseComponent::kDisturbance:
        add(model.DisturbedVelocityStd() / (sampling_.has_velocity ? white_v : white_x),
            model.disturbance.time);
        break;
    }
  }
  return parameters.cwiseMax(lower_).cwiseMin(upper_);
}

NoiseModel Scaled(NoiseModel model, double factor) {
  for (SensorNoise* sensor : {&model.velocity, &model.displacement}) {
    sensor->white_std *= factor;
    sensor->coloured.std *= factor;
  }
  model.disturbance.std *= factor;
  return model;
}

}  // namespace fathom
