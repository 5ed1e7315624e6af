// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/motion/linear_segment.h"
#include "fathom/joint_refinement/processes/process_set.h"

#include <random>
#include <vector>

#include <Eigen/Core>

namespace fathom {

// A small chain with random rows.
inline LinearSegment RandomSegment(int num_frames) {
  std::mt19937 generator(5);
  std::normal_distribution<double> normal;
  LinearSegment segment;
  segment.JgJg.setZero();
  segment.Jgr.setZero();
  std::vector<double> time;
  for (int k = 0; k < num_frames; ++k) {
    time.push_back(0.1 * k + (k > 3 ? 0.5 : 0.0));
    Eigen::MatrixXd Jd(8, 6), Jg(8, kNumColumns);
    Eigen::VectorXd r(8);
    for (double& x : Jd.reshaped()) x = 30.0 * normal(generator);
    for (double& x : Jg.reshaped()) x = 20.0 * normal(generator);
    for (double& x : r) x = normal(generator);
    segment.frames.push_back({Jd.transpose() * Jd, Jd.transpose() * Jg, Jd.transpose() * r});
    segment.JgJg += Jg.transpose() * Jg;
    segment.Jgr += Jg.transpose() * r;
    segment.rr += r.squaredNorm();
    segment.num_rows += 8.0;
  }
  segment.response.setConstant(0.02);
  LayOutDurations(time, &segment);
  return segment;
}

// With and without wanders and responses.
inline ProcessSet SomeProcesses() {
  ProcessSet set;
  set.corner_sigma = 0.8;
  for (int j = 0; j < kNumHeld; ++j) {
    set.wander[j] = {0.02 + 0.01 * j, 0.5 + 0.1 * j, 0.4 + 0.3 * j};
  }
  set.wander[2].std = 0.0;
  set.response_std = {0.0, 0.03, 0.02, 0.0, 0.05};
  set.model_error = 1e-3;
  return set;
}

}  // namespace fathom
