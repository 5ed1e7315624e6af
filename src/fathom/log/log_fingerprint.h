// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"

#include <span>
#include <string>
#include <vector>

namespace fathom {

// Tells one log's data from another's, whatever their names and folders: 16 hexadecimal digits over
// every stamp and value of its command, velocity, pose and detections (FNV-1a, 64 bits). Poses
// count only without detections, from which a tool may make them. Not for security.
std::string FingerprintOf(const Log& log);

// Of each log, in their order.
std::vector<std::string> FingerprintsOf(std::span<const Log> logs);

}  // namespace fathom
