// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"
#include "fathom/import/suggest/suggested_map.h"

namespace fathom {

// A map of the fields whose names say what they are: "thrust", "vx", "Heading". Never ready: who
// knows what an author meant by "force" has to look at it.
SuggestedMap MapByNames(const Contents& contents);

}  // namespace fathom
