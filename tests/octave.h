// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/process/run_child.h"

#include <filesystem>

namespace fathom {

inline bool HasOctave() { return RunChild({"octave-cli", {"--version"}}).exit_code == 0; }

// What a script prints is in `out`.
inline ChildResult RunInOctave(const std::filesystem::path& script) {
  return RunChild({"octave-cli", {"--quiet", script.string()}});
}

}  // namespace fathom
