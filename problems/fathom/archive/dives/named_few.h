// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

namespace fathom {

// "a", "a and b", "a, b and c", "a, b, c and 2 more": at most three of them.
std::string NamedFew(const std::vector<std::string>& names);

}  // namespace fathom
