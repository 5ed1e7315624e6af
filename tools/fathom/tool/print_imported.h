// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/log.h"

#include <filesystem>

namespace fathom {

// What a log that was made holds, a line for each stream.
void PrintStreams(const Log& log);

// What it looks like before any fit: which DOFs it can identify, and what is wrong with it.
void PrintFirstLook(const std::filesystem::path& folder, const Log& log);

}  // namespace fathom
