// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/diagnosis/options.h"

#include <string>
#include <vector>

namespace fathom::hidden {

// Names of the thresholds that a sweep may change: those of VerdictRules and SearchOptions.
std::vector<std::string> SweptRules();

// The usual options, one threshold `times` as large; counts are rounded, and stay above 0.
DiagnosisOptions WithRule(const std::string& name, double times);

}  // namespace fathom::hidden
