// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// A damping below 0 feeds the motion instead of braking it. Least squares and the adaptive law do
// not bound it, so such a model can come of a fit; it then says so, and a file that does not is
// refused.

// What a fit says of the damping `index` of kParameterInfo that came out as `value`:
// "linear_damping is negative (-3.1 ± 0.2), which is unphysical. ..."
std::string CaveatOnNegativeDamping(int index, std::string_view value);

// Whether one of `caveats` says so of this damping.
bool IsSaidToBeNegative(int index, const std::vector<std::string>& caveats);

}  // namespace fathom
