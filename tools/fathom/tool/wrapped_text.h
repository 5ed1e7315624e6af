// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fathom {

// The text with every line that is wider than `width` broken between words. What follows is
// indented to where the sentence begins: behind the last gap of two spaces or more in the first
// half of the width, else by two spaces. A longer word stays whole, and so
// do tables: from the headings above a rule of dashes to the first line without a gap. UTF-8; a
// character counts as one column wide.
//
//     yellow  gap   4 gaps of over 5 steps,
//                   the longest of 1.89 s.
std::string WrappedText(std::string_view text, std::size_t width);

}  // namespace fathom
