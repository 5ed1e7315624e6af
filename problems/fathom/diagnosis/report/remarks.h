// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/fit/identified_model.h"
#include "fathom/diagnosis/fit/preparation.h"
#include "fathom/diagnosis/judge/judgement.h"
#include "fathom/diagnosis/result.h"

#include <string>
#include <vector>

namespace fathom {

// What is to be said of the data before anything is looked for: what was dropped, counted; what
// could not be tried, and why.
std::vector<std::string> RemarksOnData(const MeasuredSegments& segments,
                                       const Preparation& preparation);

// What fathom_identify says of the model without causes: that runs differ, or that it gives none.
void AddRemarksOn(const Identified& identified, std::vector<std::string>* remarks);

// What fits best and is refused. Where suspects were refused one after the other, all of them, in
// the order of the candidates. `refusals`: one at least.
NotNamed NotNamedOf(const std::vector<Refusal>& refusals,
                    const std::vector<Candidate>& candidates,
                    const std::vector<Suspect>& suspects);

// What is to be said of a judgement: what was refused, and why; how far the data carry it.
std::vector<std::string> RemarksOnJudgement(const Judgement& judgement, bool has_velocity);

}  // namespace fathom
