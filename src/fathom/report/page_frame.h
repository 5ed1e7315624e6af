// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fathom {

// What stands inside the frame that all our pages share.
struct FramedPage {
  std::string title;                 // plain text
  std::string style;                 // CSS
  std::string body;                  // HTML, all texts escaped
  std::string data;                  // JSON, which scripts find in the element #data
  std::vector<std::string> scripts;  // JavaScript, run in this order behind the body
};

// The CSS that our pages have in common: web/page.css.
std::string_view PageStyle();

// One HTML file that may run its own script and style and load nothing at all.
std::string FramedHtml(const FramedPage& page);

}  // namespace fathom
