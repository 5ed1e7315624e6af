// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/coupled/coupled_diagnosis.h"

#include <string>
#include <vector>

namespace fathom {

// What a number means for the vehicle, a sentence or two: "Thruster lateral gives 2 % (-3 to 7 %)
// of the thrust that the vehicle file states: it pushes hardly or not at all."
std::string CauseSentence(const NamedEntry& cause, const std::string& force_unit);

// What came out, in a sentence or two.
std::string CoupledVerdictSentence(const CoupledDiagnosis& diagnosis,
                                   const CoupledIdentification& identified);

// What to do next, a sentence each. `plan_command`: plans the run that tells the causes apart;
// empty where there is none.
std::vector<std::string> CoupledNextSteps(const CoupledDiagnosis& diagnosis,
                                          const std::string& plan_command = "");

}  // namespace fathom
