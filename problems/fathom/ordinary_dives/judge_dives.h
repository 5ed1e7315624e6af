// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/ordinary_dives/ordinary_dives.h"

namespace fathom {

// docs/plan.md, "Ordinary dives". Throws InputError where the model's run diverges over a log, or
// misses nothing of it.
OrdinaryDives JudgeDives(const OrdinaryRequest& request);

}  // namespace fathom
