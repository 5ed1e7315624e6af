// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"

#include <optional>
#include <vector>

namespace fathom {

// The yaw of each row of pose.csv [rad], without the turns from pi to -pi. Nothing if a column of
// the quaternion is missing.
std::optional<std::vector<double>> UnwrappedYawOf(const Stream& pose);

}  // namespace fathom
