// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/files/json_value.h"
#include "fathom/vehicle/fitted_model.h"

#include <nlohmann/json.hpp>

namespace fathom {

// How model files hold figures: {"mae", "nmae", "n", "duration"}; a number that is not known is
// null.
nlohmann::ordered_json FormatFigures(const FitFigures& figures);
FitFigures ReadFigures(const JsonValue& json);

}  // namespace fathom
