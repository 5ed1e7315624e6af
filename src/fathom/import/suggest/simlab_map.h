// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"
#include "fathom/import/suggest/suggested_map.h"

#include <optional>

namespace fathom {

// A map for a table of uvms-simlab (github.com/edxmorgan/uvms-simlab), known by its columns: the
// wrench on the body and the estimated state, as that program's own identification takes them. The
// body is FRD, the world NED, units are SI. The columns "base_x", "base_dx", "position.x" are of
// its prediction, and left out. Nothing if another program wrote the table. Always ready.
std::optional<SuggestedMap> SimlabMap(const Contents& contents);

}  // namespace fathom
