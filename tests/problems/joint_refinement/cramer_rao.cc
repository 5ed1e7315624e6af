// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "cramer_rao.h"

#include "fathom/joint_refinement/problem/joint_state.h"
#include "fathom/joint_refinement/problem/linear_joint.h"

#include <cmath>

#include "truth.h"
#include <glog/logging.h>

namespace fathom {

ParameterVector CramerRaoStd(const CameraExperiment& experiment, const SyntheticCameraRun& run) {
  CHECK(experiment.wander == WanderKind::kFiltered || experiment.wander == WanderKind::kNone);
  Truth truth = TruthOf(run);
  JointData& data = truth.data;
  JointUnknowns& unknowns = truth.unknowns;
  ProcessSet processes;
  processes.corner_sigma = experiment.corner_noise;
  if (experiment.wander == WanderKind::kFiltered) {
    // White noise through two lags a and b: (a d/dt + 1) (b d/dt + 1) n = w.
    constexpr double a = 3.0, b = 0.5;  // [s], as in camera_experiment.cc
    for (int j = 0; j < kNumHeld; ++j) {
      const int coordinate = data.segments[0].motion.HeldCoordinate(j);
      processes.wander[j] = {coordinate < 3 ? experiment.wander_position : experiment.wander_angle,
                             1.0 / std::sqrt(a * b),
                             0.5 * (1.0 / a + 1.0 / b) * std::sqrt(a * b)};
    }
  }
  // Not part of the problem: clock, size, mount.
  GlobalsPrior prior;
  prior.std[kClockColumn] = prior.std[kSizeColumn] = 0.0;
  for (int i = 0; i < 6; ++i) prior.std[kMountColumns + i] = 0.0;
  std::vector<LinearSegment> linear;
  CHECK(Linearise(&data, unknowns, processes.corner_sigma, &linear));
  const LinearJoint joint(linear, std::vector<GlobalsPrior>{prior}, processes, data.excited);
  CHECK(joint.is_usable());
  ParameterVector std = joint.covariance(0).diagonal().head<kNumParameters>().cwiseSqrt();
  std[kInertia] *= run.truth.inertia;  // of its logarithm
  return std;
}

}  // namespace fathom
