// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/findings/finding.h"
#include "fathom/log/log.h"

#include <vector>

namespace fathom {

// What the recording of an imported log says of its stamps. `stamp_order`: over 1 % of the stamps
// of a stream lay before an earlier one. Order does not mend them, as some of them are wrong.
// `row_counter`: the stamps are a column that counts rows, so that nothing says how long a row is.
// Both are warnings.
std::vector<Finding> CheckStamps(const Log& log);

}  // namespace fathom
