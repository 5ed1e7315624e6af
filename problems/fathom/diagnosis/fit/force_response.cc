// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/force_response.h"

#include <algorithm>
#include <cmath>

namespace fathom {
namespace {

constexpr double kStep = 0.1;  // [s]; longer on long segments

}  // namespace

ForceResponse::ForceResponse(const TrainingData* data, const StructureFit& fit) : data_(data) {
  const UncoupledModel<double>& model = fit.model.baseline;
  inertia_ = model.inertia;
  for (size_t r = 0; r < data->segments().size(); ++r) {
    const MeasuredSegment& segment = data->segments()[r];
    first_points_.push_back(static_cast<int>(points_.size()));
    const double step = std::max(kStep, segment.duration() / 6000.0);
    const int count = static_cast<int>(std::ceil(segment.duration() / step)) + 1;
    OutputStamps stamps;
    stamps.start = segment.stamps.start;
    for (int i = 0; i < count; ++i) stamps.velocity.push_back(stamps.start + step * i);
    stamps.displacement = stamps.velocity;
    // What the water sees, not what the sensors show.
    ExtendedModel vehicle = fit.model;
    std::erase_if(vehicle.effects, [](const ActiveEffect& active) {
      return active.effect->info().place == Place::kSensor;
    });
    EffectOutputs outputs;
    if (!EffectSimulation(segment.inputs.get(), stamps).Run(vehicle, fit.initial[r], &outputs)) {
      points_.clear();
      return;
    }
    for (int i = 0; i < count; ++i) {
      const double v = outputs.velocity[i];
      const double rate = std::max(
          1e-9, (model.linear_damping + 2.0 * model.quadratic_damping * std::abs(v)) / inertia_);
      const double kept = std::exp(-rate * step);
      points_.push_back({stamps.velocity[i],
                         v,
                         outputs.displacement[i],
                         segment.inputs->command.At(stamps.velocity[i]),
                         static_cast<int>(r)});
      kept_.push_back(kept);
      given_.push_back((1.0 - kept) / (rate * inertia_));
    }
  }
  first_points_.push_back(static_cast<int>(points_.size()));
}

Eigen::VectorXd ForceResponse::Outputs(const std::vector<double>& force) const {
  Eigen::VectorXd outputs(data_->bins().size());
  std::vector<double> velocity(points_.size()), position(points_.size());
  for (size_t r = 0; r + 1 < first_points_.size(); ++r) {
    const int first = first_points_[r], end = first_points_[r + 1];
    velocity[first] = position[first] = 0.0;
    for (int i = first + 1; i < end; ++i) {
      velocity[i] = kept_[i] * velocity[i - 1] + given_[i] * 0.5 * (force[i - 1] + force[i]);
      const double step = points_[i].time - points_[i - 1].time;
      position[i] = position[i - 1] + 0.5 * step * (velocity[i - 1] + velocity[i]);
    }
    const double start = points_[first].time;
    const double step = end > first + 1 ? points_[first + 1].time - start : 1.0;
    for (int row = data_->bins().first_row(r); row < data_->bins().first_row(r + 1); ++row) {
      const NoiseSample& sample = data_->samples()[row];
      const auto& values = sample.channel == NoiseChannel::kVelocity ? velocity : position;
      const double place = std::clamp((sample.time - start) / step, 0.0, end - first - 1.0);
      const int low = first + std::min(static_cast<int>(place), end - first - 2);
      const double share = place - (low - first);
      outputs[row] = (1.0 - share) * values[low] + share * values[low + 1];
    }
  }
  return outputs;
}

}  // namespace fathom
