// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/joint_refinement/joint_refinement.h"
#include "fathom/joint_refinement/pose_chart.h"

#include <span>
#include <vector>

namespace fathom {

// The coordinate of eta that a DOF moves, from the mean attitude of all runs.
ExcitedCoordinate ExcitedCoordinateOf(Dof dof, std::span<const CameraRun> runs);

// The first guesses of a run in the chart, angles unwrapped, each coordinate the median of the
// frames around: what flips or flies off for a few frames is gone, and a steady motion stays.
std::vector<PoseVector> SteadyPoses(const CameraRun& run);

// Where the search starts: output error on the displacement of the steady poses.
UncoupledModel<double> FirstModel(const JointInput& input,
                                  const ExcitedCoordinate& excited,
                                  const std::vector<std::vector<PoseVector>>& steady);

}  // namespace fathom
