// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>

namespace fathom {

// Text from outside as a message shows it: what cannot be printed as \x.., cut after 60 characters.
std::string Printable(std::string_view text);

// The same in single quotes.
std::string Quoted(std::string_view text);

}  // namespace fathom
