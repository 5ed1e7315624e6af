// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/findings/finding.h"
#include "fathom/findings/inertia_check.h"
#include "fathom/log/log.h"
#include "fathom/signal/signals.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fathom {

// What every program checks before a fit: stamps and motion of each log (stamp_check.h,
// motion_check.h), and command and
// motion together (signal_check.h) in the training part of `signals`, which are those of all logs.
// Warnings first.
std::vector<Finding> CheckLogs(std::span<const Log> logs, const Signals& signals);

// The same of the best source that each log has, with the other columns of velocity.csv, which
// couplings take. Throws InputError as SignalsOf() does.
std::vector<Finding> CheckLogs(std::span<const Log> logs, Dof dof);

// The same of several DOFs together, each finding once, and whether poses and velocities are one
// motion (pose_twist_check.h). What is of one DOF begins with its name. A DOF that a log does not
// command or measure is passed over.
std::vector<Finding> CheckLogs(std::span<const Log> logs, const std::vector<Dof>& dofs);

// Why no model can come of such data, whatever the method: the sentence on a command or a velocity
// that never changes; empty if there is none.
std::string WhyNoModel(const std::vector<Finding>& findings);

// The body that the logs agree on: their mass, the size in the vehicle file that they name, and
// what the logs hold. Nothing if none knows its mass, or two have different bodies. Throws
// InputError if that file breaks its format.
std::optional<Body> BodyOf(std::span<const Log> logs);

}  // namespace fathom
