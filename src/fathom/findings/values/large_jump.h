// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

namespace fathom {

// The size from which a change between neighbours is a jump: five times the large ones (the 90 %
// quantile) of the changes that usually come, given by their sizes. 0 if there are none.
double LargeJump(std::vector<double> usual_changes);

}  // namespace fathom
