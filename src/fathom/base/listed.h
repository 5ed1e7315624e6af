// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

namespace fathom {

// "surge", "surge and sway", "surge, sway and yaw"; empty of none.
std::string Listed(const std::vector<std::string>& names);

}  // namespace fathom
