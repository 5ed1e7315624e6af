// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace fathom {

// A path as tables and pages show it: bytes that are not UTF-8, and control characters, as \xff.
// Every other character stays, in any alphabet. Two paths of one text do not occur, since a
// backslash is shown as two.
std::string PathText(const std::filesystem::path& path);

// The same of a text in which backslashes stay: what a program wrote.
std::string CleanText(std::string_view text);

}  // namespace fathom
