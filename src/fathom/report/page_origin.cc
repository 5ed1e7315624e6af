// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/page_origin.h"

#include "fathom/report/html_text.h"

#include <cstddef>

#include <fmt/format.h>

namespace fathom {
namespace {

// More logs than these are folded away.
constexpr std::size_t kLogsAtOnce = 3;

std::string LogHtml(const LogOfPage& log) {
  std::string html = "<li>" + HtmlText(log.name);
  if (!log.span.empty()) html += ", " + HtmlText(log.span);
  if (!log.fingerprint.empty()) {
    html += ", fingerprint <code>" + HtmlText(log.fingerprint) + "</code>";
  }
  return html + "</li>\n";
}

}  // namespace

std::string OriginHtml(const PageOrigin& origin) {
  if (origin.version.empty() && origin.command.empty() && origin.logs.empty()) return "";
  std::string html = fmt::format("<div class=\"origin\">\n<p>{}, {}: <code>{}</code></p>\n",
                                 HtmlText(origin.version),
                                 HtmlText(origin.date),
                                 HtmlText(origin.command));
  if (!origin.logs.empty()) {
    std::string list = "<ul>\n";
    for (const LogOfPage& log : origin.logs) list += LogHtml(log);
    list += "</ul>\n";
    html += origin.logs.size() <= kLogsAtOnce
                ? list
                : fmt::format("<details class=\"notes\"><summary>{} logs</summary>\n{}</details>\n",
                              origin.logs.size(),
                              list);
  }
  return html + "</div>\n";
}

}  // namespace fathom
