// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/page.h"

#include "fathom/report/curve_chart.h"
#include "fathom/report/html_text.h"
#include "fathom/report/page_frame.h"
#include "fathom/report/palette.h"
#include "fathom/report/parameter_chart.h"
#include "fathom/report/plan_chart.h"
#include "fathom/report/scatter_chart.h"
#include "fathom/report/table_html.h"
#include "fathom/report/time_chart_json.h"
#include "fathom/report/web/assets.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

// A few sections can be seen at a glance; more need a way to jump.
constexpr std::size_t kSectionsWithoutContents = 2;

std::string Paragraphs(const std::vector<std::string>& texts, std::string_view kind) {
  std::string html;
  for (const std::string& text : texts) {
    html += fmt::format("<p class=\"{}\">{}</p>\n", kind, HtmlText(text));
  }
  return html;
}

std::string NotesHtml(const std::vector<std::string>& notes) {
  if (notes.empty()) return "";
  return "<details class=\"notes\"><summary>Data</summary>\n" + Paragraphs(notes, "text") +
         "</details>\n";
}

std::string FoldHtml(const PageFold& fold) {
  std::string html = "<details class=\"more\"><summary>" + HtmlText(fold.summary) + "</summary>\n" +
                     Paragraphs(fold.text, "text") + CurveChartsHtml(fold.curves);
  for (const Table& table : fold.tables) html += TableHtml(table);
  return html + "</details>\n";
}

std::string FactsHtml(const std::vector<Fact>& facts) {
  if (facts.empty()) return "";
  std::string html = "<dl class=\"facts\">\n";
  for (const Fact& fact : facts) {
    html += fmt::format(
        "<div><dt>{}</dt><dd>{}</dd></div>\n", HtmlText(fact.name), HtmlText(fact.value));
  }
  return html + "</dl>\n";
}

std::string ContentsHtml(const std::vector<PageSection>& sections) {
  if (sections.size() <= kSectionsWithoutContents) return "";
  std::string html = "<nav>";
  for (std::size_t i = 0; i < sections.size(); ++i) {
    html += fmt::format("<a href=\"#section-{}\">{}</a>", i, HtmlText(sections[i].heading));
  }
  return html + "</nav>\n";
}

// The frame of a chart; page.js draws into it.
std::string TimeChartHtml(const TimePanel& panel, std::size_t section, std::size_t index) {
  std::string html =
      fmt::format("<figure class=\"time\" aria-label=\"{} over time\">", HtmlText(panel.quantity));
  if (!panel.title.empty()) {
    html += fmt::format("<figcaption><b>{}</b></figcaption>", HtmlText(panel.title));
  }
  html += fmt::format(
      "<div class=\"chart\" data-section=\"{}\" data-panel=\"{}\"></div>", section, index);
  if (panel.time.size() > kMostStamps) {
    html +=
        fmt::format("<p class=\"hint\">Thinned for display from {} stamps; every peak is kept.</p>",
                    panel.time.size());
  }
  return html + "</figure>\n";
}

std::string ParameterChartsHtml(const std::vector<ParameterPanel>& panels, Palette& palette) {
  if (panels.empty()) return "";
  std::string html = "<div class=\"parameters\">\n";
  for (const ParameterPanel& panel : panels) html += ParameterChartHtml(panel, palette);
  html += "</div>\n";
  const bool has_interval = std::ranges::any_of(panels, [](const ParameterPanel& panel) {
    return std::ranges::any_of(panel.estimates,
                               [](const Estimate& estimate) { return estimate.std > 0.0; });
  });
  if (has_interval) {
    html +=
        "<p class=\"hint\">Dots are estimates, bars 95 % intervals; the numbers give one "
        "standard deviation.</p>\n";
  }
  return html;
}

std::string SectionHtml(const PageSection& section, std::size_t index, Palette& palette) {
  std::string html = fmt::format("<section id=\"section-{}\">\n", index);
  if (!section.heading.empty()) html += "<h2>" + HtmlText(section.heading) + "</h2>\n";
  html += Paragraphs(section.text, "text");
  html += Paragraphs(section.warnings, "warning");
  for (const PlanPanel& panel : section.plan_panels) html += PlanChartHtml(panel);
  for (std::size_t i = 0; i < section.time_panels.size(); ++i) {
    html += TimeChartHtml(section.time_panels[i], index, i);
  }
  html += CurveChartsHtml(section.curve_panels);
  for (const PageFold& fold : section.folds) html += FoldHtml(fold);
  html += ScatterChartsHtml(section.scatter_panels, palette);
  html += ParameterChartsHtml(section.parameter_panels, palette);
  for (const Table& table : section.tables) html += TableHtml(table);
  html += NotesHtml(section.notes);
  return html + "</section>\n";
}

}  // namespace

std::string RenderPage(const Page& page) {
  Palette palette;
  std::vector<std::string> sections;
  for (const PageSection& section : page.sections) {
    std::vector<std::string> charts;
    for (const TimePanel& panel : section.time_panels) {
      charts.push_back(TimeChartJson(panel, palette));
    }
    sections.push_back(fmt::format("[{}]", fmt::join(charts, ",")));
  }
  FramedPage framed;
  framed.title = page.title;
  framed.style = fmt::format("{}\n{}", web::uplot_css, PageStyle());
  framed.data = fmt::format("[{}]", fmt::join(sections, ","));
  framed.scripts = {
      fmt::format(
          "/* uPlot draws the charts. Its licence:\n{}*/\n{}\n", web::uplot_license, web::uplot_js),
      std::string(web::chart_style_js),
      std::string(web::time_cuts_js),
      std::string(web::time_plot_js),
      std::string(web::legend_js),
      std::string(web::chart_keys_js),
      std::string(web::chart_touch_js),
      std::string(web::csv_js),
      std::string(web::reload_js),
      std::string(web::page_selftest_js),
      std::string(web::page_js)};

  std::string& html = framed.body;
  html += "<header>\n<h1>" + HtmlText(page.title) + "</h1>\n";
  if (!page.subtitle.empty()) html += "<p class=\"subtitle\">" + HtmlText(page.subtitle) + "</p>\n";
  html += Paragraphs(page.lead, "lead");
  html += FactsHtml(page.facts);
  html += Paragraphs(page.warnings, "warning");
  html += OriginHtml(page.origin);
  html += ContentsHtml(page.sections);
  html += "</header>\n";
  html += page.reload_after > 0.0 ? fmt::format("<main data-reload=\"{}\">\n", page.reload_after)
                                  : "<main>\n";
  html +=
      "<noscript><p class=\"warning\">The charts over time need JavaScript; all else is "
      "here.</p></noscript>\n";
  for (std::size_t i = 0; i < page.sections.size(); ++i) {
    html += SectionHtml(page.sections[i], i, palette);
  }
  html += "</main>\n";
  if (!page.footer.empty()) html += "<footer>" + HtmlText(page.footer) + "</footer>\n";
  return FramedHtml(framed);
}

}  // namespace fathom
