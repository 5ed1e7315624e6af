// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/search/screen.h"

#include <string>
#include <vector>

namespace fathom {

// The experiment that would tell a cause from its rivals, as a sentence; EFFECTS.md's "What cannot
// be told apart". Where no experiment of this kind can, it says what could.
std::string DecidingExperiment(const Suspect& cause, const std::vector<Suspect>& rivals);

}  // namespace fathom
