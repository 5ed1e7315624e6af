// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/dof.h"
#include "fathom/findings/finding.h"
#include "fathom/log/log.h"
#include "fathom/signal/sources/source.h"

#include <vector>

namespace fathom {

// What the measured motion shows by itself, before any model; docs/findings.md. All are warnings
// but for samples held for less than 0.3 s.
//
//   sentinel        a number that stands for "no reading"
//   lost_values     exact zeros while the vehicle moves
//   stuck_values    a sensor that stood still
//   held_samples    a slow sensor written at a higher rate
//   repeated_block  rows that occur twice
//
// Of velocity.csv the column of `dof`; of the poses their positions, or for an angular DOF their
// quaternions, of which the first finding of each kind is told.
std::vector<Finding> CheckMotion(const Log& log, Dof dof, Source source);

// The same of all other columns of velocity.csv: of what a model with couplings takes.
std::vector<Finding> CheckOtherMotion(const Log& log, Dof dof);

}  // namespace fathom
