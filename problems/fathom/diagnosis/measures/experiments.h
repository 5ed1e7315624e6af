// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/result.h"
#include "fathom/diagnosis/search/suspect.h"

#include <vector>

namespace fathom {

// The experiment that would tell a cause from its rivals; EFFECTS.md's "What cannot be told apart".
DecidingRun DecidingExperiment(const Suspect& cause, const std::vector<Suspect>& rivals);

}  // namespace fathom
