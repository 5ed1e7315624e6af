// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/measures/evidence.h"

#include "fathom/diagnosis/fit/residual_noise.h"
#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>

namespace fathom {
namespace {

double ShareLeft(const TrainingData& data, const Eigen::VectorXd& residual) {
  double speed2 = 0.0, num_speeds = 0.0;
  for (const MeasuredSegment& segment : data.segments()) {
    for (const double v : PlainSegment(segment).velocity) {
      speed2 += v * v;
      num_speeds += 1.0;
    }
  }
  const NoiseModel left = WhiteNoise(data, residual);
  return std::max(left.velocity.white_std, left.displacement.white_std) /
         std::sqrt(speed2 / num_speeds);
}

}  // namespace

Evidence EvidenceOf(const TrainingData& data, const StructureFit& baseline) {
  return {.inertia = baseline.model.baseline.inertia,
          .inertia_std = std::sqrt(baseline.covariance(kInertia, kInertia)),
          .share_left = ShareLeft(data, baseline.residual),
          .command_tone = data.command_tone()};
}

bool LeavesNothing(const TrainingData& data, const StructureFit& fit) {
  return ShareLeft(data, fit.residual) < Evidence::kNegligible;
}

double WanderRatio(const TrainingData& data, const Eigen::VectorXd& residual) {
  const NoiseModel all = WhiteNoise(data, residual);
  const NoiseModel scatter = SensorNoiseOnly(data, residual);
  const auto& samples = data.samples();
  const bool has_velocity =
      std::any_of(samples.begin(), samples.end(), [](const NoiseSample& sample) {
        return sample.channel == NoiseChannel::kVelocity;
      });
  return has_velocity ? all.velocity.white_std / scatter.velocity.white_std
                      : all.displacement.white_std / scatter.displacement.white_std;
}

}  // namespace fathom
