// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/report/coupled_models_html.h"

#include "fathom/archive/report/archive_sentences.h"
#include "fathom/archive/report/dives_json.h"
#include "fathom/report/format_value.h"
#include "fathom/report/html_text.h"

#include <map>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

using CoupledKey = std::pair<std::string, std::string>;  // log, DOFs

std::string NamedText(const CauseRow& cause) {
  const std::string text = cause.parameter + " " + FormatValue(cause.value, cause.std);
  return cause.unit == "1" ? text : text + " " + UnitText(cause.unit);
}

// By log and DOFs, what `rows` say of each.
template <typename Row, typename Text>
std::map<CoupledKey, std::string> TextsOf(const std::vector<Row>& rows, const Text& text) {
  std::map<CoupledKey, std::string> texts;
  for (const Row& row : rows) {
    std::string& all = texts[{row.log, row.dof}];
    if (!all.empty()) all += ", ";
    all += text(row);
  }
  return texts;
}

std::string DofsHtml(const CoupledKey& key, const ArchiveReport& report) {
  const auto page = report.pages.find(key);
  if (page == report.pages.end()) return HtmlText(key.second);
  return fmt::format(
      "<a href=\"{}\">{}</a>", HtmlText(AddressOf(page->second)), HtmlText(key.second));
}

}  // namespace

std::string CoupledModelsHtml(const ArchiveReport& report) {
  const auto verdicts =
      TextsOf(report.tables.verdicts, [](const VerdictRow& row) { return row.verdict; });
  const auto named = TextsOf(report.tables.causes, NamedText);
  const auto found = [](const std::map<CoupledKey, std::string>& texts, const CoupledKey& key) {
    const auto text = texts.find(key);
    return text == texts.end() ? std::string("–") : HtmlText(text->second);
  };
  std::string rows;
  CoupledKey last;
  for (const FitRow& fit : report.tables.fits) {
    const CoupledKey key = {fit.log, fit.dof};
    if (fit.family != kCoupledFamily || key == last) continue;
    last = key;
    rows += fmt::format("<tr><td>{}</td><td>{}</td>", HtmlText(fit.log), DofsHtml(key, report));
    rows += fit.usable ? fmt::format("<td>{}</td><td>{}</td><td>{}</td></tr>\n",
                                     HtmlText(fit.source),
                                     found(verdicts, key),
                                     found(named, key))
                       : fmt::format("<td>–</td><td>no usable fit</td><td>{}</td></tr>\n",
                                     HtmlText(fit.message));
  }
  if (rows.empty()) return "";
  const std::string out = LeftOutSentence(report.tables);
  const std::string left_out = out.empty() ? "" : "<p class=\"text\">" + HtmlText(out) + "</p>\n";
  return "<section id=\"coupled\">\n<h2>Coupled models</h2>\n"
         "<p class=\"text\">" +
         HtmlText(CoupledSentence(report.tables)) + "</p>\n" + left_out +
         "<p class=\"hint\">One model of several degrees of freedom for each log: the structure "
         "that the data show, and the numbers beyond a diagonal model, ± one standard "
         "deviation.</p>\n<div class=\"table\"><table class=\"coupled-models\">\n<thead><tr>"
         "<th>log</th><th>DOFs</th><th>structure</th><th>verdict</th><th>named</th></tr></thead>\n"
         "<tbody>\n" +
         rows + "</tbody></table></div>\n</section>\n";
}

}  // namespace fathom
