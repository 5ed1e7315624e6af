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

// The same without a cut, and with what is UTF-8 left as it is: control characters only are shown
// as \x.., which would otherwise move the cursor of a terminal, or set its title. A text of one
// line has no line ends of its own, a text of several keeps these and its tabs.
std::string ShownOnOneLine(std::string_view text);
std::string ShownOnLines(std::string_view text);

}  // namespace fathom
