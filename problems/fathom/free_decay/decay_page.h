// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/free_decay/log_decay.h"
#include "fathom/report/page.h"

namespace fathom {

// What a decay tells, its stretches as measured and simulated, and how they were chosen.
PageSection DecaySection(const LogDecay& decay);

}  // namespace fathom
