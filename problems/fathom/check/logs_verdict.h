// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/check/logs_checkup.h"

#include <span>
#include <string>
#include <vector>

namespace fathom {

// The parameters of a DOF in which its logs differ by more than they know, a sentence each.
std::vector<std::string> Disagreements(const DofOfLogs& of_dof);

// What to think of several logs, in a sentence or two. It acquits no log that gives no model, and
// names what speaks against the others without being red: poor fits, inertias above
// UsualInertia(), logs that disagree.
std::string LogsVerdict(std::span<const CheckedLog> logs, std::span<const DofOfLogs> dofs);

}  // namespace fathom
