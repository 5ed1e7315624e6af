// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/diagnosis.h"

#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// What a colleague would say of a diagnosis, in a few sentences: what share of the error, because
// of what and how large, what cannot be told apart and which experiment would tell, how the error
// on unseen data changes, and which parameter of the model moves most.
std::string VerdictSentence(const Diagnosis& diagnosis);

// What to do about each cause, and what would decide between those that cannot be told apart; or,
// where no cause is named, what that means. A sentence or two each.
std::vector<std::string> NextSteps(const Diagnosis& diagnosis);

// Standard deviations of the parameters of one effect of a model; NaN where not known.
std::vector<double> EffectStds(const DiagnosedModel& model, int effect_index);

// "0.42 s (0.39 to 0.45 s)": the number with its 95 % interval, rounded at the first digit of the
// interval's half width (the second, if the first is a 1); the interval ends at the bounds. Without
// a known standard deviation the number alone, to four digits.
std::string WithInterval(
    double value, double std, std::string_view unit, double lower, double upper);

}  // namespace fathom
