// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fathom {

// "1 frame", "2 frames": of a noun whose plural takes an s.
std::string Plural(std::size_t count, std::string_view noun);

}  // namespace fathom
