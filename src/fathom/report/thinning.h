// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

namespace fathom {

// Which stamps to draw so that a picture of all curves looks as if all had been drawn: the stamps
// are cut into equal runs, and of each run the highest, the lowest and the first missing (NaN)
// value of each curve are kept, and the two ends. Sorted; at most `most` of them; all of them if
// there are no more than that.
std::vector<std::size_t> ThinnedIndices(const std::vector<std::vector<double>>& curves,
                                        std::size_t num_stamps,
                                        std::size_t most);

}  // namespace fathom
