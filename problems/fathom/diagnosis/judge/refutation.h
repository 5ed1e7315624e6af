// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/judge/held_out.h"
#include "fathom/diagnosis/options.h"
#include "fathom/diagnosis/search/search_result.h"
#include "fathom/diagnosis/search/suspects.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace fathom {

// What the held-out data may ask of a cause.
enum class Burden {
  kNotToLose,  // that they do not speak against it, as IsRefuted() has it
  kToGain,     // that they gain by it for certain (95 %)
};

// The gain by which data that no fit has seen speak against what is named, where that is all there
// is: for certain, or as far as they go by so much (5 %) that it should not be built on. Nothing if
// they do not. What acts on the poses alone is judged by them, where a loss of 1 % is a trace, as
// of a jump before the held-out data; the velocities, which it moves no more than the fit moves,
// speak against it from half a percent on.
std::optional<Gain> RefutingGain(const Scored& scored,
                                 bool acts_on_poses_alone,
                                 std::uint64_t seed);

// Leaves out of the best hypothesis every cause that does not bear its burden on the held-out
// records, one at a time (what acts on the poses alone and does not gain 5 % in them for certain
// must not lose in the velocities either): the best hypothesis of fewer causes without it takes the
// place. Where causes need only not to lose, the last one stays: Diagnose() asks all data of it. A
// remark for each that goes.
void LeaveOutTheRefuted(const TrainingData& data,
                        const std::vector<Record>& held_out,
                        const std::vector<Suspect>& suspects,
                        const DiagnosisOptions& options,
                        Burden burden,
                        SearchResult* search,
                        std::vector<std::string>* remarks);

}  // namespace fathom
