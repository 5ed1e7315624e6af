// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/result.h"
#include "fathom/report/panel.h"

#include <vector>

namespace fathom {

// For each log: what was measured against the free runs of the baseline and of the extended model.
std::vector<TimePanel> FreeRunPanels(const Diagnosis& diagnosis);

// For each log with Diagnosis::pose_traces: the displacements that were measured against those of
// both models.
std::vector<TimePanel> PosePanels(const Diagnosis& diagnosis);

// The command below each of the other panels, on the same time axis; a panel without stamps where
// none is known.
std::vector<TimePanel> CommandPanels(const Diagnosis& diagnosis,
                                     const std::vector<ResidualTrace>& traces);

// The missing force with its band of two standard deviations, and the part of it that the causes
// account for; a panel for each stretch over which its stamps rise.
std::vector<TimePanel> MissingForcePanels(const Diagnosis& diagnosis);

// The missing force over each suspect that there is.
std::vector<ScatterPanel> SuspectPanels(const Diagnosis& diagnosis);

// One small plot per parameter, before and after.
std::vector<ParameterPanel> ParameterPanels(const Diagnosis& diagnosis);

}  // namespace fathom
