// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"

#include <span>
#include <string>
#include <vector>

namespace fathom {

// A name for each log by which it can be told from the others: its own; "name (folder)" where
// several have that one, with the whole path where their folders are called the same as well; and
// "name (folder) 2" for the same log again.
std::vector<std::string> DistinctNames(std::span<const Log> logs);

}  // namespace fathom
