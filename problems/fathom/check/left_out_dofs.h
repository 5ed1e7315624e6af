// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/check/logs_checkup.h"

#include <span>
#include <string>
#include <vector>

namespace fathom {

// Which DOFs of several logs are not compared, or without which of the logs, and why: a sentence
// for each DOF that not all logs give a model of.
std::vector<std::string> LeftOutDofs(std::span<const CheckedLog> logs);

}  // namespace fathom
