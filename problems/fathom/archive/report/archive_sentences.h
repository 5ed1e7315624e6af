// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/archive/report/archive_report.h"

#include <cstddef>
#include <string>
#include <vector>

namespace fathom {

// What changed over the dives, the surest first. Of a vehicle without a change: that there is none,
// or that too few dives have a usable joint fit to tell. Last, where many models of single logs are
// poor, that changes can hide behind that. At least one sentence.
std::vector<std::string> ChangeSentences(const Tables& tables);

// The dives of whose DOFs none has a usable joint fit, the first three by name with the reason: "Of
// 2 dives no DOF has a usable joint fit: dive_3 (surge: ...) and dive_7 (no log of it gave a
// model)." Empty if there is none.
std::string DivesWithoutFitSentence(const Tables& tables);

// "12 coupled models: 10 consistent, 2 explained. They name thrust_gain.port (2 logs).", and
// whether the changes are those of coupled models. Empty if there is none.
std::string CoupledSentence(const Tables& tables);

// Which DOFs --dofs=auto leaves out of the coupled models though they move, and why. Empty if there
// is none.
std::string LeftOutSentence(const Tables& tables);

// How many logs in how many dives, and what became of them: every log is in one of the counts.
std::string LogsSentence(const ArchiveReport& report);

}  // namespace fathom
