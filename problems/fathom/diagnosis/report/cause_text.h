// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// The effect that a cause is.
const ActiveEffect& EffectOfCause(const Diagnosis& diagnosis, const Cause& cause);

// Standard deviations of the parameters of one effect of a model; NaN where not known.
std::vector<double> EffectStds(const DiagnosedModel& model, int effect_index);

// What the logs cannot tell from a cause, each once, in their order.
std::vector<Alternative> AlternativesOf(const Cause& cause);

std::vector<std::string> LabelsOf(const std::vector<Alternative>& alternatives);

// Where a cause and what it may be instead act: "of the actuator or in the water".
std::string PlacesText(const Diagnosis& diagnosis, const Cause& cause);

// What to do about a cause: the effect's own advice, unless a step of the force is larger than the
// RMS command, which no payload is.
std::string AdviceText(const Diagnosis& diagnosis, const Cause& cause);

// What a cause is and how large, and what it may be instead: "a thruster dead zone
// (thrust_dead_zone), width 8.0 N (7.7 to 8.3 N), or from a steady current (steady_current)".
// `preposition` stands before each alternative, as the sentence has it before the cause: "from " or
// "". Of more than four alternatives the place is named: "an effect of the actuator: ... fits best,
// and 5 others fit as well".
std::string ReasonText(const Diagnosis& diagnosis,
                       const Cause& cause,
                       std::string_view preposition);

// "a or b"; "any of a, b, c, d, e" of more than four.
std::string AnyOf(const std::vector<std::string>& labels);

// The experiment that decides, as a sentence: "To decide: the same experiment again, longer." Where
// none can, what says so; empty where nothing is open.
std::string ToDecide(const Cause& cause);

}  // namespace fathom
