// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"
#include "fathom/import/suggest/suggested_map.h"

namespace fathom {

// A map for a log of Rock, by the types of its streams and Rock's axes (body FLU, world with z up).
// Never ready: no type says that its six efforts are the wrench of the body.
SuggestedMap RockMap(const Contents& contents);

}  // namespace fathom
