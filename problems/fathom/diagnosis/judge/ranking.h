// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/judge/judgement.h"
#include "fathom/diagnosis/result.h"

#include <vector>

namespace fathom {

// The causes that are named, in the order of their model's effects, each with what these segments
// cannot tell from it and the experiment that would; their held-out gains are left at 0.
std::vector<Cause> CausesOf(const Judgement& judgement);

// Every suspect with what became of it, the best first.
std::vector<Candidate> RankCandidates(const Judgement& judgement);

// The model that is named without one of its causes, refitted if it was tried so.
ExtendedModel WithoutCause(const Judgement& judgement, const Cause& cause);

}  // namespace fathom
