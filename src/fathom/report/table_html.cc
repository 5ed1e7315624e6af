// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/table_html.h"

#include "fathom/report/html_text.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

#include <fmt/format.h>
#include <glog/logging.h>

namespace fathom {
namespace {

// Bytes behind the ± of the widest interval of a column; 0 if it has none.
std::size_t IntervalWidth(const Table& table, std::size_t column) {
  std::size_t width = 0;
  for (const TableRow& row : table.rows) {
    const std::string& cell = row.cells[column];
    const std::size_t at = cell.find(kPlusMinus);
    if (at != std::string::npos) width = std::max(width, cell.size() - at - kPlusMinus.size());
  }
  return width;
}

// The part from the ± on stands in a box of its own, equally wide in all rows.
std::string NumberHtml(const std::string& cell, std::size_t interval_width) {
  if (interval_width == 0) return HtmlText(cell);
  const std::size_t at = std::min(cell.find(kPlusMinus), cell.size());
  const std::string interval = at < cell.size() ? "± " + cell.substr(at + kPlusMinus.size()) : "";
  return fmt::format(R"({}<span class="interval" style="width:{}ch">{}</span>)",
                     HtmlText(cell.substr(0, at)),
                     interval_width + 2,
                     HtmlText(interval));
}

std::string_view RowClass(RowFlag flag) {
  switch (flag) {
    case RowFlag::kBest:
      return "best";
    case RowFlag::kKept:
      return "kept";
    case RowFlag::kUnusable:
      return "unusable";
    case RowFlag::kNone:
      break;
  }
  return "";
}

}  // namespace

std::string TableHtml(const Table& table) {
  std::string html;
  if (!table.fold.empty()) {
    html += "<details class=\"fold\"><summary>" + HtmlText(table.fold) + "</summary>\n";
  }
  html += "<div class=\"table\"><table>\n";
  if (!table.caption.empty()) html += "<caption>" + HtmlText(table.caption) + "</caption>\n";
  html += "<thead><tr>";
  std::vector<std::size_t> interval_widths;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    for (const TableRow& row : table.rows) CHECK_EQ(row.cells.size(), table.columns.size());
    interval_widths.push_back(IntervalWidth(table, i));
    html += fmt::format("<th{}>{}</th>",
                        table.columns[i].is_number ? " class=\"number\"" : "",
                        HtmlText(table.columns[i].heading));
  }
  html += "</tr></thead>\n<tbody>\n";
  for (const TableRow& row : table.rows) {
    const std::string_view flag = RowClass(row.flag);
    html += fmt::format("<tr class=\"{}\">", flag);
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      // The heading stands beside the cell where the window is too narrow for columns.
      const std::string name =
          i == 0 ? "" : fmt::format(" data-name=\"{}\"", HtmlText(table.columns[i].heading));
      if (table.columns[i].is_number) {
        html += fmt::format(
            "<td class=\"number\"{}>{}", name, NumberHtml(row.cells[i], interval_widths[i]));
      } else {
        html += fmt::format("<td{}>{}", name, HtmlText(row.cells[i]));
      }
      const bool is_label = i + 1 == row.cells.size() && !flag.empty();
      if (is_label) html += fmt::format(" <span class=\"flag\">{}</span>", flag);
      html += "</td>";
    }
    html += "</tr>\n";
  }
  html += "</tbody>\n</table></div>\n";
  if (!table.fold.empty()) html += "</details>\n";
  return html;
}

}  // namespace fathom
