// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/fit/residual_noise.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fathom {
namespace {

constexpr double kQuietest = 1e-4;  // of the motion

double RootMeanSquare(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return values.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(values.size()));
}

// Measured, or what measured displacements go through [m/s] or [rad/s].
double UsualSpeed(const TrainingData& data) {
  std::vector<double> speeds, quotients;
  int last = -1;
  for (int i = 0; i < data.bins().size(); ++i) {
    const NoiseSample& sample = data.samples()[i];
    if (sample.channel == NoiseChannel::kVelocity) {
      speeds.push_back(data.measured()[i]);
      continue;
    }
    if (last >= 0 && data.samples()[last].segment == sample.segment &&
        sample.time > data.samples()[last].time) {
      quotients.push_back((data.measured()[i] - data.measured()[last]) /
                          (sample.time - data.samples()[last].time));
    }
    last = i;
  }
  return RootMeanSquare(speeds.empty() ? quotients : speeds);
}

}  // namespace

NoiseModel QuietestSensors(const TrainingData& data) {
  NoiseModel noise;
  noise.velocity.white_std = noise.displacement.white_std =
      std::max(1e-12, kQuietest * UsualSpeed(data));
  return noise;
}

NoiseModel WhiteNoise(const TrainingData& data, const Eigen::VectorXd& residual) {
  double velocity = 0.0, displacement = 0.0;
  int num_velocities = 0, num_displacements = 0;
  for (int i = 0; i < data.bins().size(); ++i) {
    const bool is_velocity = data.samples()[i].channel == NoiseChannel::kVelocity;
    (is_velocity ? velocity : displacement) +=
        residual[i] * residual[i] / data.samples()[i].variance_factor;
    ++(is_velocity ? num_velocities : num_displacements);
  }
  NoiseModel noise;
  noise.velocity.white_std = std::max(1e-12, std::sqrt(velocity / std::max(1, num_velocities)));
  noise.displacement.white_std =
      std::max(1e-12, std::sqrt(displacement / std::max(1, num_displacements)));
  return noise;
}

NoiseModel SensorNoiseOnly(const TrainingData& data, const Eigen::VectorXd& residual) {
  NoiseModel noise = QuietestSensors(data);
  for (const NoiseChannel channel : {NoiseChannel::kVelocity, NoiseChannel::kDisplacement}) {
    std::vector<double> values, factors;
    for (int i = 0; i < data.bins().size(); ++i) {
      if (data.samples()[i].channel != channel) continue;
      values.push_back(residual[i]);
      factors.push_back(data.samples()[i].variance_factor);
    }
    // Of one or two the values themselves.
    double sum = 0.0, count = 6.0 * (static_cast<double>(values.size()) - 2.0);
    for (size_t i = 2; i < values.size(); ++i) {
      const double d = values[i] - 2.0 * values[i - 1] + values[i - 2];
      sum += d * d * 6.0 / (factors[i - 2] + 4.0 * factors[i - 1] + factors[i]);
    }
    if (values.size() < 3) {
      count = std::max<double>(1.0, static_cast<double>(values.size()));
      for (const double value : values) sum += value * value;
    }
    const double std = std::sqrt(sum / count);
    double& white_std =
        (channel == NoiseChannel::kVelocity ? noise.velocity : noise.displacement).white_std;
    white_std = std::max(std, white_std);
  }
  return noise;
}

}  // namespace fathom
