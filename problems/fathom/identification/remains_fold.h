// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/identification/identification.h"
#include "fathom/identification/residual_structure.h"
#include "fathom/report/page.h"
#include "fathom/signal/signals.h"

#include <string>

namespace fathom {

// A sentence on how much samples of the residual agree over time, and on what intervals of the
// family then rely; empty without an autocorrelation.
std::string AutocorrelationSentence(const ResidualStructure& structure, Family family);

// A sentence on where the power of the residual lies against the band that the command excites;
// empty without a spectrum.
std::string SpectrumSentence(const ResidualStructure& structure);

// "What the model leaves": both as charts with their sentences, and the correlation of the
// parameters.
PageFold RemainsFold(const Identification& taken, const Signals& scored);

}  // namespace fathom
