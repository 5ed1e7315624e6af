// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/identification/identification.h"

namespace fathom {

// A result that no fit has touched: all numbers chosen by hand, all different.
inline Identification HandmadeRow(Family family, double train_nmae, double held_out_nmae) {
  Identification row;
  row.family = family;
  row.source = Source::kPoseEstimator;
  row.is_usable = true;
  row.message = "converged";
  row.fitted.dof = Dof::kSurge;
  row.fitted.force_unit = "N";
  row.fitted.model = {
      .inertia = 40.0, .quadratic_damping = 30.0, .linear_damping = 5.0, .buoyancy = -0.5};
  // Standard deviations 2, 1.5, 0.5, 0.1; inertia and linear damping correlated by -0.6.
  row.fitted.covariance.setZero();
  row.fitted.covariance.diagonal() << 4.0, 2.25, 0.25, 0.01;
  row.fitted.covariance(kInertia, kLinearDamping) = -0.6;
  row.fitted.covariance(kLinearDamping, kInertia) = -0.6;
  row.fitted.train = {
      .mae = 0.5 * train_nmae, .nmae = train_nmae, .num_samples = 90, .duration = 8.9};
  row.fitted.held_out = {
      .mae = 0.25 * held_out_nmae, .nmae = held_out_nmae, .num_samples = 40, .duration = 3.9};
  return row;
}

inline Identification UnusableRow(Family family) {
  Identification row;
  row.family = family;
  row.fitted.dof = Dof::kSurge;
  row.fitted.force_unit = "N";
  row.message = "the command never changes";
  return row;
}

// `num_samples` stamps 0.1 s apart at rest, without command.
inline Segment SegmentAtRest(double start, int num_samples) {
  Segment segment;
  for (int i = 0; i < num_samples; ++i) segment.time.push_back(start + 0.1 * i);
  segment.velocity.assign(num_samples, 0.0);
  segment.command.time = segment.time;
  segment.command.value.assign(num_samples, 0.0);
  return segment;
}

}  // namespace fathom
