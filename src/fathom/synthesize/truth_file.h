// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/synthesize/experiment/experiment.h"
#include "fathom/vehicle/extended_model.h"
#include "fathom/vehicle/files/vehicle_file.h"

#include <cstdint>
#include <span>
#include <string>

namespace fathom {

// What a synthetic log was made from, as JSON "fathom-truth-1" (docs/file_formats.md): never part
// of the log itself, which would tell the diagnosis.
std::string FormatTruth(const Vehicle& vehicle,
                        const Experiment& experiment,
                        std::span<const ActiveEffect> effects,
                        std::uint64_t seed);

}  // namespace fathom
