// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/force_response.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fathom {
namespace {

constexpr double kStep = 0.1;  // [s]; longer on long segments

// How fast a model's forces in the water resist more, at every point of its run.
struct Slopes {
  std::vector<double> over_velocity, over_position;
};

Slopes SlopesOf(const std::vector<RunPoint>& points,
                const TrainingData& data,
                const ExtendedModel& model) {
  constexpr double kProbe = 1e-4;  // [m/s] or [rad/s], [m] or [rad]
  Slopes slopes = {std::vector<double>(points.size(), 0.0),
                   std::vector<double>(points.size(), 0.0)};
  for (const ActiveEffect& active : model.effects) {
    if (!IsForceInWater(*active.effect)) continue;
    for (const auto& [of, slope] : {std::pair(&RunPoint::velocity, &slopes.over_velocity),
                                    std::pair(&RunPoint::position, &slopes.over_position)}) {
      std::vector<RunPoint> more = points, less = points;
      for (RunPoint& point : more) point.*of += kProbe;
      for (RunPoint& point : less) point.*of -= kProbe;
      const auto with_more = ForceAlong(more, data.segments(), model.baseline, active);
      const auto with_less = ForceAlong(less, data.segments(), model.baseline, active);
      for (size_t i = 0; i < points.size(); ++i) {
        (*slope)[i] += (with_less[i] - with_more[i]) / (2.0 * kProbe);
      }
    }
  }
  return slopes;
}

}  // namespace

ForceResponse::ForceResponse(const TrainingData* data, const StructureFit& fit) : data_(data) {
  const UncoupledModel<double>& model = fit.model.baseline;
  std::vector<double> durations;  // of the steps [s]
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
      points_.push_back({stamps.velocity[i],
                         outputs.velocity[i],
                         outputs.displacement[i],
                         segment.inputs->command.At(stamps.velocity[i]),
                         static_cast<int>(r)});
      durations.push_back(step);
    }
  }
  first_points_.push_back(static_cast<int>(points_.size()));
  const Slopes slopes = SlopesOf(points_, *data, fit.model);
  for (size_t i = 0; i < points_.size(); ++i) {
    const double damping = model.linear_damping +
                           2.0 * model.quadratic_damping * std::abs(points_[i].velocity) +
                           slopes.over_velocity[i];
    steps_.push_back(StepOver(durations[i],
                              std::max(1e-9, damping / model.inertia),
                              slopes.over_position[i] / model.inertia,
                              model.inertia));
  }
}

// The matrix exponential in closed form, the force being constant; without a stiffness the position
// is the mean speed's.
ForceResponse::Step ForceResponse::StepOver(double h, double a, double b, double inertia) {
  Step step;
  if (b == 0.0) {
    step.v_from_v = std::exp(-a * h);
    step.v_from_force = (1.0 - step.v_from_v) / (a * inertia);
    step.x_from_v = 0.5 * h * (1.0 + step.v_from_v);
    step.x_from_force = 0.5 * h * step.v_from_force;
    return step;
  }
  const double half = 0.5 * a, square = b - half * half;
  const double root = std::sqrt(std::max(std::abs(square), 1e-18));
  double c = 0.0, s = 0.0;
  if (square > 0.0) {
    const double decay = std::exp(-half * h);
    c = decay * std::cos(root * h);
    s = decay * std::sin(root * h) / root;
  } else {
    const double slow = std::exp((root - half) * h), fast = std::exp(-(root + half) * h);
    c = 0.5 * (slow + fast);
    s = 0.5 * (slow - fast) / root;
  }
  step.v_from_v = c - half * s;
  step.v_from_x = -b * s;
  step.v_from_force = s / inertia;
  step.x_from_v = s;
  step.x_from_x = c + half * s;
  step.x_from_force = (1.0 - step.x_from_x) / (b * inertia);
  return step;
}

Eigen::VectorXd ForceResponse::Outputs(const std::vector<double>& force) const {
  std::vector<double> mean(force.size(), 0.0);
  for (size_t i = 1; i < force.size(); ++i) mean[i] = 0.5 * (force[i - 1] + force[i]);
  return OutputsOfMeans(mean);
}

Eigen::VectorXd ForceResponse::OutputsOfMeans(const std::vector<double>& mean_force) const {
  Eigen::VectorXd outputs(data_->bins().size());
  std::vector<double> velocity(points_.size()), position(points_.size());
  for (size_t r = 0; r + 1 < first_points_.size(); ++r) {
    const int first = first_points_[r], end = first_points_[r + 1];
    velocity[first] = position[first] = 0.0;
    for (int i = first + 1; i < end; ++i) {
      const Step& step = steps_[i];
      const double mean = mean_force[i];
      const double v = velocity[i - 1], x = position[i - 1];
      velocity[i] = step.v_from_v * v + step.v_from_x * x + step.v_from_force * mean;
      position[i] = step.x_from_v * v + step.x_from_x * x + step.x_from_force * mean;
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
