// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/comparison/comparison.h"
#include "fathom/joint_refinement/joint_refinement.h"
#include "fathom/joint_refinement/logs/marker_logs.h"

#include <optional>
#include <string>
#include <vector>

namespace fathom {

struct ImageComparisonOptions {
  IdentificationOptions identification;

  // The row that the joint search starts from; absent: what FitJoint() chooses.
  std::optional<Family> initial_guess = {};
};

// What each family makes of the same images: least squares, adaptive law and output error on the
// PnP poses, and the joint refinement on the corners.
struct ImageComparison {
  Comparison comparison;  // of one DOF; the joint row is the last one
  JointSummary joint;
  std::vector<MarkerLogs::Moved> moved_markers;
};

// What the joint refinement found a DOF to do that is not excited, along or about the mean body
// axis.
struct HeldDofFound {
  Dof dof = Dof::kSurge;
  HeldWander wander;
  double response_std = 0.0;  // see ProcessSet
};

// Empty where the refinement is not usable.
std::vector<HeldDofFound> HeldDofsOf(const ImageComparison& comparison);

// Scored by free runs against the logs' velocity streams where all of them have one, else against
// the derivative of the PnP poses: a remark says which. The joint row is OrBestGuess(); the
// search does not start where the family of `initial_guess` is not usable. Throws InputError for
// options that cannot be used.
ImageComparison CompareOnImages(const MarkerLogs& logs, const ImageComparisonOptions& options);

}  // namespace fathom
