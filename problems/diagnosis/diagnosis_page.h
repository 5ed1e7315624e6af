// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/diagnosis.h"
#include "fathom/report/page.h"
#include "fathom/report/panel.h"
#include "fathom/report/table.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace fathom {

// The causes: what each is, how large with its 95 % interval, and how sure it is.
Table CauseTable(const Diagnosis& diagnosis);

// The parameters of the baseline alone and with the causes in, and the causes' own, with their
// standard deviations.
Table BeforeAndAfterTable(const Diagnosis& diagnosis);

// The first `most` candidates, best first, with why each was kept or dropped.
Table CandidateTable(const Diagnosis& diagnosis,
                     std::size_t most = std::numeric_limits<std::size_t>::max());

// For each log: what was measured against the free runs of the baseline and of the extended model.
std::vector<TimePanel> FreeRunPanels(const Diagnosis& diagnosis);

// The missing force with its band of two standard deviations, and the part of it that the causes
// account for; a panel for each stretch over which its stamps rise.
std::vector<TimePanel> MissingForcePanels(const Diagnosis& diagnosis);

// The missing force over each suspect that there is.
std::vector<ScatterPanel> SuspectPanels(const Diagnosis& diagnosis);

// One small plot per parameter, before and after.
std::vector<ParameterPanel> ParameterPanels(const Diagnosis& diagnosis);

// All of it on one page, the sentence first.
Page DiagnosisPage(const Diagnosis& diagnosis);

}  // namespace fathom
