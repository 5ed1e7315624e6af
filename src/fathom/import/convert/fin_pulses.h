// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/import/map/import_map.h"
#include "fathom/log/log.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fathom {

// Turns the pulses of a servo into the angles of its fin, of those columns whose map has `pulses`:
//
//   angle = +- largest (p - middle) / (p > middle ? most - middle : middle - least)
//
// `largest`: of the map, else of the vehicle's fin. Below 0 of a `reversed` one. A pulse beyond the
// ends gives the angle there; where the output is off, the fin counts as straight. Remarks count
// both. Throws InputError where nothing tells the largest angle.
void AnglesOfPulses(const std::filesystem::path& file,
                    const StreamMap& command,
                    const std::optional<Vehicle>& vehicle,
                    Stream* fins,
                    std::vector<std::string>* remarks);

}  // namespace fathom
