// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/page_frame.h"

#include "fathom/report/html_text.h"
#include "fathom/report/web/assets.h"

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr std::string_view kHead = R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'">
)";

// JSON that may stand inside a script element: without '<' nothing in it can end the element.
std::string ScriptSafe(std::string_view json) {
  std::string text;
  text.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

}  // namespace

std::string_view PageStyle() { return web::page_css; }

std::string FramedHtml(const FramedPage& page) {
  std::string html(kHead);
  html += fmt::format("<title>{}</title>\n", HtmlText(page.title));
  html += fmt::format("<style>\n{}</style>\n</head>\n<body>\n", page.style);
  html += page.body;
  html += "<script type=\"application/json\" id=\"data\">" + ScriptSafe(page.data) + "</script>\n";
  for (const std::string& script : page.scripts) html += "<script>\n" + script + "</script>\n";
  return html + "</body>\n</html>\n";
}

}  // namespace fathom
