// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"
#include "fathom/import/suggest/suggested_map.h"

namespace fathom {

// A map for an .alog, by the names and units of MOOS-IvP: NAV_* and DESIRED_*. Never ready: which
// way a rudder turns the vehicle, and whether it did what it was told, stands in no log.
SuggestedMap MoosMap(const Contents& contents);

}  // namespace fathom
