// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/vehicle/files/json_value.h"
#include "fathom/vehicle/fitted_model.h"

namespace fathom {

// How files hold figures: {"mae", "nmae", "n", "duration"}; a number that is not known is null.
template <typename Json>
Json JsonOfFigures(const FitFigures& figures) {
  return {{"mae", figures.mae},
          {"nmae", figures.nmae},
          {"n", figures.num_samples},
          {"duration", figures.duration}};
}

FitFigures ReadFigures(const JsonValue& json);

}  // namespace fathom
