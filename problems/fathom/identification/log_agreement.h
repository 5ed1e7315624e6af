// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/identification/identification.h"
#include "fathom/identification/run_agreement.h"
#include "fathom/signal/joined_signals.h"

#include <cstddef>
#include <string>
#include <vector>

namespace fathom {

// The training segments of one of several logs.
Signals TrainingOf(std::size_t log, const JoinedSignals& joined);

// Fits each log alone by the family of `together`, the model of all of them, and widens the
// intervals of that by what the logs differ by more than by noise; its caveats say so. `names`: of
// the logs.
RunAgreement WidenByAgreement(const std::vector<std::string>& names,
                              const JoinedSignals& joined,
                              const IdentificationOptions& options,
                              Identification* together);

}  // namespace fathom
