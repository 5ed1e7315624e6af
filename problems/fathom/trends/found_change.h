// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/trends/change.h"
#include "fathom/trends/series_model.h"

namespace fathom {

// One found column with the values on its two sides, in the parameter's unit and with standard
// deviations that hold the scatter between dives: docs/archive_trends.md (1). Other changes of the
// series are as they are at the step; for a trend, at the first dive of the series.
Change ChangeOf(const SeriesModel& model,
                std::size_t found_index,
                double tau_squared,
                int num_dives);

}  // namespace fathom
