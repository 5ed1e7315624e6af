// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/motion/global_columns.h"

#include <vector>

#include <Eigen/Core>

namespace fathom {

// The corners of one frame, linearised: with d the deviation of the frame's pose from its mean and
// g the change of the globals, the frame adds to the cost
//
//   1/2 |r + J_d d + J_g g|^2
struct LinearFrame {
  Eigen::Matrix<double, 6, 6> JdJd;
  Eigen::Matrix<double, 6, kNumColumns> JdJg;
  Eigen::Matrix<double, 6, 1> Jdr;
};

// One segment, linearised. All at corners' residuals in pixels: divide by corner_sigma^2.
struct LinearSegment {
  std::vector<LinearFrame> frames;
  Eigen::Matrix<double, kNumColumns, kNumColumns> JgJg;
  Eigen::Matrix<double, kNumColumns, 1> Jgr;
  double rr = 0.0;

  // What the loss of the outliers is beyond their weighted squares [no unit]: a constant of the
  // linear problem, which only another linearisation changes.
  double clipped = 0.0;
  double num_rows = 0.0;  // weighted

  // Durations between neighbouring frames [s], each once, and which holds after frame k. Rounded to
  // a tenth of a millisecond: far below what changes a process, and few are then different.
  std::vector<double> durations;
  std::vector<int> duration_after;

  // The response's coefficients at the point of linearisation.
  Eigen::Matrix<double, kNumResponse, 1> response;
};

// Fills durations and duration_after for frames at `time`.
void LayOutDurations(const std::vector<double>& time, LinearSegment* segment);

}  // namespace fathom
