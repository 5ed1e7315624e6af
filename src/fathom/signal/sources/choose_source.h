// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/log/log.h"
#include "fathom/signal/sources/source.h"

#include <vector>

namespace fathom {

// The sources that a log has for `dof`, the best one first.
std::vector<Source> SourcesOf(const Log& log, Dof dof);

// The best of them; kPoseEstimator where there is none, so that its reader says what is missing.
Source BestSourceOf(const Log& log, Dof dof);

// The log without the motion stream of the other source, if it has this one.
Log WithSourceOnly(Log log, Source source);

}  // namespace fathom
