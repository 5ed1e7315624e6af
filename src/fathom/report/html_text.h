// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>

namespace fathom {

// Plain text as it stands in HTML, in an element or in a quoted attribute: & < > " ' are replaced,
// and so is what is not UTF-8.
std::string HtmlText(std::string_view text);

}  // namespace fathom
