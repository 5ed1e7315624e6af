// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/judge/confirmation.h"
#include "fathom/diagnosis/judge/verdict_rules.h"
#include "fathom/diagnosis/measures/free_run_comparison.h"
#include "fathom/diagnosis/measures/held_out.h"
#include "fathom/diagnosis/measures/left_out_blocks.h"

#include <optional>
#include <vector>

namespace fathom {

// Leaves out of a choice every delay or lag under half of the step between two samples of the
// motion, one at a time: how a log is sampled, or a simulation stepped, does as much. The best
// hypothesis of fewer causes without it takes the place.
Choice LeaveOutTheTooFine(const TrainingData& data, const WeighedSearch& search, Choice choice);

// Leaves out of a choice every cause that the held-out segments speak against, one at a time (what
// acts on the poses alone and does not gain 5 % in them for certain must not lose in the velocities
// either): the best hypothesis of fewer causes without it takes the place. The last one stays:
// Judge() asks all data of it.
Choice LeaveOutWhatLoses(const TrainingData& data,
                         const std::vector<MeasuredSegment>& held_out,
                         const WeighedSearch& search,
                         const VerdictRules& rules,
                         Choice choice);

// The same of every cause that does not gain on them for certain (95 %), the last one as well.
Choice LeaveOutWhatDoesNotGain(const TrainingData& data,
                               const std::vector<MeasuredSegment>& held_out,
                               const WeighedSearch& search,
                               const VerdictRules& rules,
                               Choice choice);

// Several logs that hold nothing out: leaves out of a choice every cause of all logs that those
// left out in turn do not confirm. The best hypothesis of no more causes without it takes the
// place, as long as there are few.
Choice LeaveOutTheUnconfirmed(const TrainingData& data,
                              const LeftOutParts& logs,
                              const WeighedSearch& search,
                              const VerdictRules& rules,
                              Choice choice);

// Whether logs that are left out in turn gain for certain (95 %), or each of them gains. Of two or
// three logs the interval is so wide that the second counts.
bool IsConfirmedByLogs(const Gain& gain, const VerdictRules& rules = {});

// The gain by which data that no fit has seen speak against what is named, where that is all there
// is: for certain, or as far as they go by so much (5 %) that it should not be built on. Nothing if
// they do not. What acts on the poses alone is judged by them, where a loss of 1 % is a trace, as
// of a jump before the held-out data; the velocities, which it moves no more than the fit moves,
// speak against it from half a percent on.
std::optional<Gain> RefutingGain(const Scored& scored,
                                 bool acts_on_poses_alone,
                                 const VerdictRules& rules = {});

// Why nothing of what was chosen is to be named after all; nothing if it is. `by_left_out_blocks`:
// nothing was held out. `remains`: what the causes leave is more than noise.
std::optional<Refusal> RefusalOfAll(const std::vector<int>& causes,
                                    const FreeRunComparison& runs,
                                    bool by_left_out_blocks,
                                    bool remains,
                                    const VerdictRules& rules = {});

}  // namespace fathom
