// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/judge/evidence_remarks.h"

#include "fathom/vehicle/parameters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kNegligible = 1e-3;  // share of the motion

// The baseline's residual as a share of the motion: of the speed, and of the way made in a second.
// The larger of the two.
double ShareLeft(const TrainingData& data, const StructureFit& baseline) {
  double speed2 = 0.0, num_speeds = 0.0;
  for (const Record& record : data.records()) {
    for (const double v : SegmentOfRecord(record).velocity) {
      speed2 += v * v;
      num_speeds += 1.0;
    }
  }
  const NoiseModel left = WhiteNoise(data, baseline.residual);
  return std::max(left.velocity.white_std, left.displacement.white_std) /
         std::sqrt(speed2 / num_speeds);
}

}  // namespace

bool IsNegligible(const TrainingData& data, const StructureFit& baseline) {
  return ShareLeft(data, baseline) < kNegligible;
}

double WanderRatio(const TrainingData& data, const StructureFit& fit) {
  const NoiseModel all = WhiteNoise(data, fit.residual);
  const NoiseModel scatter = SensorNoiseOnly(data, fit.residual);
  const auto& samples = data.samples();
  const bool has_velocity =
      std::any_of(samples.begin(), samples.end(), [](const NoiseSample& sample) {
        return sample.channel == NoiseChannel::kVelocity;
      });
  return has_velocity ? all.velocity.white_std / scatter.velocity.white_std
                      : all.displacement.white_std / scatter.displacement.white_std;
}

void AddRemarksOnTheEvidence(const TrainingData& data,
                             const StructureFit& baseline,
                             Diagnosis* diagnosis) {
  const double inertia = baseline.model.baseline.inertia;
  const double std = std::sqrt(baseline.covariance(kInertia, kInertia));
  if (!(std < inertia)) {
    diagnosis->remarks.push_back(
        fmt::format("Without causes these logs do not determine the model: the inertia is {:.3g} "
                    "with a standard deviation of {:.2g}. Take what is said here as a hint.",
                    inertia,
                    std));
  }
  if (!diagnosis->has_velocity) {
    diagnosis->remarks.push_back(
        "These poses have no velocities beside them. A wrong scale of theirs (marker size, "
        "refraction) leaves no trace: one of 1 + e divides inertia and linear damping by 1 + e and "
        "quadratic damping by its square. A clock of theirs that differs from the command's is the "
        "same as a delay of the command (time_offset). A velocity sensor tells both.");
  }
  if (const double share_left = ShareLeft(data, baseline); share_left < kNegligible) {
    diagnosis->remarks.push_back(
        fmt::format("Without any cause the model leaves {:.2g} % of the motion. Below {:.2g} % no "
                    "cause is looked for.",
                    100.0 * share_left,
                    100.0 * kNegligible));
    return;
  }
  const Tone& tone = data.command_tone();
  if (tone.IsAlone() && !diagnosis->causes.empty()) {
    diagnosis->remarks.push_back(
        fmt::format("The command is little more than a single sine of {:.2g} rad/s: one second is "
                    "{:.0f} degrees of its phase, and any delay or lag of that phase looks nearly "
                    "the same.",
                    tone.frequency,
                    tone.frequency * 180.0 / std::numbers::pi));
  }
}

}  // namespace fathom
