// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>

namespace fathom {

// A text as a POSIX shell takes it for one word: as it stands where it can, else in quotes. Every
// command that a program proposes names its files so, and can be typed as it is printed.
std::string ShellWord(std::string_view text);

}  // namespace fathom
