// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/log.h"
#include "fathom/simulate/effect_simulation.h"

#include <optional>
#include <string>
#include <vector>

namespace fathom {

// The displacement along `dof` of a log with poses. Nothing without poses; nothing, and a remark in
// which the log is `name`, where they are too few, or where the vehicle turns so much that no fixed
// direction is its displacement's.
std::optional<SampledSignal> PoseCoordinate(const Log& log,
                                            const std::string& name,
                                            Dof dof,
                                            std::vector<std::string>* remarks);

}  // namespace fathom
