// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/coupled/coupled_data.h"
#include "fathom/simulate/coupled/manoeuvre_run.h"

#include <cstddef>
#include <optional>

namespace fathom {

// What a log measured, with the angle of a fin of its command [index], at the stamps of the longest
// segment's velocities. Angles on straight lines between the command's stamps. Nothing if the log
// knows no attitude, or no stamps lie within the command.
std::optional<ManoeuvreTrack> LoggedTrack(const CoupledData& data, std::size_t fin);

}  // namespace fathom
