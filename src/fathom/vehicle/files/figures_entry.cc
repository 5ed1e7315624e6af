// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/files/figures_entry.h"

#include <cmath>
#include <limits>

namespace fathom {

FitFigures ReadFigures(const JsonValue& json) {
  FitFigures figures;
  figures.mae = json.NumberIfThere("mae");
  figures.nmae = json.NumberIfThere("nmae");
  if (const double duration = json.NumberIfThere("duration"); std::isfinite(duration)) {
    figures.duration = duration;
  }
  const double num_samples = json.NumberIfThere("n");
  if (num_samples >= 0.0 && num_samples <= std::numeric_limits<int>::max()) {
    figures.num_samples = static_cast<int>(num_samples);
  }
  return figures;
}

}  // namespace fathom
