// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// The name that `column` would have in SI, if it is one of `known_names` with a unit behind it:
// "t_ms" -> "t", "u [cm/s]" -> "u", "tau_surge_kN" -> "tau_surge". Other words for time ("time_s",
// "timestamp") stand for "t" where that is known. Nothing for any other column, such as "u_std".
std::optional<std::string> NameWithoutUnit(std::string_view column,
                                           const std::vector<std::string>& known_names);

}  // namespace fathom
