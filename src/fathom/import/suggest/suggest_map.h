// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/recording/recording.h"
#include "fathom/import/suggest/map_with_when.h"
#include "fathom/import/suggest/suggested_map.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace fathom {

// A map of what a recording seems to hold. `vehicle`: of the thrusters that its commands drive,
// where it is known. The first of `own` that fits goes before everything else.
SuggestedMap SuggestMap(const Recording& recording,
                        const std::optional<Vehicle>& vehicle,
                        std::span<const MapWithWhen> own = {});

// What SuggestMap() looks for in a recording of that format, a clause.
std::string WhatIsLookedFor(std::string_view format);

}  // namespace fathom
