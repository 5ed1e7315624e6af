// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/findings/finding.h"

#include <optional>

namespace fathom {

// Two masses of one vehicle, of code "mass": `in_log` [kg] from log.yaml, by which everything goes,
// and `in_vehicle` [kg] from the vehicle file; both above 0. A note where one is over 1.1 times the
// other, as ballast or a payload may make it; a warning over twice: one of them is wrong.
std::optional<Finding> CheckMass(double in_log, double in_vehicle);

}  // namespace fathom
