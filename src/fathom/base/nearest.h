// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// The candidate that `text` was probably meant to be: one that begins with it, or can be reached by
// changing, adding, dropping or swapping few letters (one, or a third of the text's). The first of
// equals; empty where none is that near.
std::string Nearest(std::string_view text, const std::vector<std::string>& candidates);

}  // namespace fathom
