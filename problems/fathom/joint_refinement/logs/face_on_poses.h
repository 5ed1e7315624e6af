// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/log.h"

#include <functional>

namespace fathom {

// Where the track of a log says that its poses may lose motion to the tilt of a single marker
// (RemarkOnLostMotion), and `dof` is a translation along the line of sight, makes Log::pose anew
// from the detections, all frames of a segment together: the other DOFs are held, each with a
// wander that the corners tell, and `dof` moves freely (JointOptions::moves_freely). Frames in
// segments of fewer than ten are left out. A remark on it replaces the track's; where nothing comes
// of it, or the calibration cannot be read, the log stays as it is, and a remark says why. Does
// nothing to a log without detections. `on_round` is JointOptions::on_round.
//
// Across the line of sight a motion and a turn look alike, and what is taken for the wander would
// take part of the motion: such poses stay as they are. docs/joint_refinement.md, "Without a model"
void RefineFaceOnPoses(Dof dof, Log* log, const std::function<void(int, int)>& on_round = {});

}  // namespace fathom
