// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "truth.h"

#include <cmath>

#include <glog/logging.h>

namespace fathom {

Truth TruthOf(const SyntheticCameraRun& run) {
  const CameraSegment& camera = run.input.segments[0];
  Truth truth;
  truth.data.setup = {run.input.camera, run.input.body_from_camera};
  truth.data.excited = Index(run.input.dof);
  truth.data.segments.push_back(
      {camera.detections,
       run.input.map,
       PredictedMotion(camera.command, camera.time, truth.data.excited, MotionScales())});
  PredictedMotion& motion = truth.data.segments[0].motion;
  truth.unknowns.model = {std::log(run.truth.inertia),
                          run.truth.quadratic_damping,
                          run.truth.linear_damping,
                          run.truth.buoyancy};
  truth.unknowns.segments.resize(1);
  SegmentUnknowns& own = truth.unknowns.segments[0];
  own.start = {run.true_velocity[0], run.true_displacement[0]};
  CHECK(motion.Update(truth.unknowns.Motion(0)));
  const size_t n = camera.time.size();
  own.deviation.resize(n);
  own.rate.resize(n);
  for (size_t k = 0; k < n; ++k) {
    PoseVector::Map(own.deviation[k].data()) =
        VectorFromPose(run.true_world_from_body[k]) - motion.Mean(k);
  }
  return truth;
}

}  // namespace fathom
