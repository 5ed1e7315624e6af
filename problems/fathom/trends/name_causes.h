// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/trends/change.h"
#include "fathom/trends/change_search.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fathom {

// What happened to the vehicle, from the pattern of what changed: archive_trends.md (7) to (9).
//
// `search` is what FindChanges said of the same estimates with the same options. Changes at the
// same dive, give or take one, are one event; so are all trends. Each event is judged over every
// DOF and parameter, beside the other events. What a cause moves is then known, and the archive is
// searched once more for what is left. Events are in the order of dives, trends first; the changes
// of an event hold values before and after from the joint fit, and p-values of `search` where it
// found that change, else NaN.
//
// `dive_names` has a name for each dive, in order; `num_dives` of the search was its size.
std::vector<ChangeEvent> NameCauses(const ChangeSearch& search,
                                    std::span<const DiveEstimate> estimates,
                                    std::span<const std::string> dive_names,
                                    const std::optional<Vehicle>& vehicle,
                                    const ChangeOptions& options);

}  // namespace fathom
