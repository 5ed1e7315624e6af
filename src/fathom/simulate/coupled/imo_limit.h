// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/simulate/coupled/manoeuvre.h"

#include <optional>
#include <string_view>

namespace fathom {

// What a figure may be at most for a ship of this length [m] at this speed [m/s], by IMO
// MSC.137(76): of a turning circle at 35 degrees, of the zigzags 10/10 and 20/20, and of a stop
// full astern. Nothing of other figures and manoeuvres.
std::optional<double> ImoLimit(const Manoeuvre& manoeuvre,
                               std::string_view figure,
                               double length,
                               double ahead);

}  // namespace fathom
