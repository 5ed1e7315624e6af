// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/page.h"

#include <cmath>
#include <regex>
#include <string>

#include "example_page.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

int Count(const std::string& text, const std::string& wanted) {
  int count = 0;
  for (std::size_t at = text.find(wanted); at != std::string::npos;
       at = text.find(wanted, at + 1)) {
    ++count;
  }
  return count;
}

// A page that shows `text` wherever a page shows a text.
Page PageOf(const std::string& text) {
  TimePanel motion;
  motion.title = motion.quantity = motion.unit = text;
  motion.time = {0.0, 1.0};
  motion.measured = Series{text, {0.0, 1.0}, text};
  motion.responses = {{text, {0.0, 0.5}, text}};
  ParameterPanel parameter;
  parameter.name = parameter.unit = parameter.reference_name = text;
  parameter.estimates = {{text, 1.0, 0.1}};
  parameter.reference = 1.0;
  Table table;
  table.caption = text;
  table.columns = {{text}, {text, true}};
  table.rows = {{{text, text}}};
  Page page;
  page.title = page.subtitle = page.footer = text;
  page.lead = page.warnings = {text};
  page.facts = {{text, text}};
  PageSection section{text, {text}, {text}, {motion}, {parameter}, {table}};
  page.sections = {section, section, section};
  return page;
}

TEST(Page, ReferencesNothingOutsideItself) {
  std::string html = RenderPage(ExamplePage());
  const std::string licence_comment = "/*! https://github.com/leeoniya/uPlot (v1.6.32) */";
  const std::size_t at = html.find(licence_comment);
  ASSERT_NE(at, std::string::npos);
  html.erase(at, licence_comment.size());
  for (const char* reference : {"http:", "https:", "src=", "url(", "@import", "<link", "import("}) {
    EXPECT_EQ(html.find(reference), std::string::npos) << reference;
  }
  EXPECT_EQ(Count(html, "href="), Count(html, "href=\"#section-"));
  EXPECT_GT(Count(html, "Copyright (c) 2022 Leon Sorokin"), 0);
}

TEST(Page, LoadsItselfAgainOnlyWhereItGrows) {
  Page page = ExamplePage();
  EXPECT_EQ(Count(RenderPage(page), "<main>"), 1);
  page.reload_after = 2.5;
  EXPECT_EQ(Count(RenderPage(page), "<main data-reload=\"2.5\">"), 1);
}

TEST(Page, NoTextBreaksOutOfItsPlace) {
  const int num_scripts = Count(RenderPage(PageOf("harmless")), "<script");
  const std::string html = RenderPage(PageOf("</script><script>alert(1)</script>\"' onload='x"));
  EXPECT_EQ(Count(html, "<script"), num_scripts);
  EXPECT_EQ(Count(html, "</script>"), num_scripts);
  EXPECT_EQ(Count(html, "<script>alert"), 0);
  // Inside the data quotes are JSON's business; in front of them, in HTML, they are escaped.
  const std::string before_data = html.substr(0, html.find("<script type=\"application/json\""));
  EXPECT_EQ(Count(before_data, "' onload='"), 0);
  EXPECT_GT(Count(html, "&lt;/script&gt;&lt;script&gt;alert(1)"), 0);
}

TEST(Page, ShowsWhatIsNotUtf8AsAReplacement) {
  const std::string html = RenderPage(PageOf("caf\xe9"));
  EXPECT_EQ(Count(html, "caf\xe9"), 0);
  EXPECT_GT(Count(html, "caf\xef\xbf\xbd"), 0);
}

TEST(Page, WritesGapsAsNull) {
  Page page = PageOf("x");
  page.sections[0].time_panels[0].measured->values = {std::nan(""), 0.25};
  EXPECT_GT(Count(RenderPage(page), R"("values":[null,0.25])"), 0);
}

TEST(Page, CountsStampsFromAnEpochFromTheirWholeSecond) {
  Page page = PageOf("x");
  page.sections[0].time_panels[0].time = {1.7e9 + 0.25, 1.7e9 + 2.5};
  page.sections[0].time_panels[0].held_out = {{1.7e9 + 1.0, 1.7e9 + 2.0}};
  const std::string html = RenderPage(page);
  EXPECT_GT(Count(html, R"("time":[0.25,2.5],"time_offset":1700000000.0)"), 0);
  EXPECT_GT(Count(html, R"("held_out":[[1.0,2.0]])"), 0);
}

TEST(Page, ThinsLongSeriesAndSaysSo) {
  Page page = PageOf("x");
  TimePanel& panel = page.sections[0].time_panels[0];
  const int n = 60'000;
  panel.time.clear();
  for (int i = 0; i < n; ++i) panel.time.push_back(0.01 * i);
  panel.measured->values.assign(n, 0.5);
  panel.responses[0].values.assign(n, 0.5);
  panel.responses[0].values[34'567] = 0.8765432;
  const std::string html = RenderPage(page);
  EXPECT_GT(Count(html, "Thinned for display from 60000 stamps"), 0);
  EXPECT_GT(Count(html, "0.8765432"), 0);
  // All three sections together: far below the 60 000 stamps times "0.5,".
  EXPECT_LT(Count(html, "0.5,"), 50'000);
  EXPECT_EQ(Count(RenderPage(PageOf("x")), "Thinned"), 0);
}

TEST(Page, GivesAFamilyTheSameColourInEveryChart) {
  const std::string html = RenderPage(ExamplePage());
  // "adaptive" comes second in the first section; it has no response in the third, yet "joint"
  // keeps the colour it had. It has a dot for each of four parameters in three sections.
  EXPECT_GT(Count(html, R"("color":"#d55e00","is_faded":false,"name":"adaptive")"), 0);
  EXPECT_EQ(Count(html, R"("color":"#cc79a7","is_faded":false,"name":"joint")"), 3);
  EXPECT_EQ(Count(html, R"(background:#cc79a7"></i></span><span class="value">)"), 12);
}

TEST(Page, GivesCurvesOfOneMeaningOneColour) {
  Page page = PageOf("x");
  TimePanel& panel = page.sections[0].time_panels[0];
  for (const char* name : {"limit -1 m", "limit 2 m"}) {
    Series& line = panel.responses.emplace_back(panel.responses[0]);
    line.name = name;
    line.color_name = "limit";
  }
  const std::string html = RenderPage(page);
  std::smatch low, high;
  ASSERT_TRUE(std::regex_search(
      html, low, std::regex(R"x("color":"(#\w+)","is_faded":false,"name":"limit -1 m")x")));
  ASSERT_TRUE(std::regex_search(
      html, high, std::regex(R"x("color":"(#\w+)","is_faded":false,"name":"limit 2 m")x")));
  EXPECT_EQ(low[1], high[1]);
}

TEST(Page, SaysInItsHeaderWhereItComesFrom) {
  Page page;
  page.origin = {"Fathom 0.1.0", "2026-11-25T14:31:02Z", "fathom_compare --log='a b'", {}};
  for (int i = 0; i < 3; ++i) {
    page.origin.logs.push_back({"pool <" + std::to_string(i) + ">", "0.0 s to 9.9 s", "00ff"});
  }
  std::string html = RenderPage(page);
  const std::string header = html.substr(0, html.find("</header>"));
  for (const char* text : {"Fathom 0.1.0, 2026-11-25T14:31:02Z",
                           "<code>fathom_compare --log=&#39;a b&#39;</code>",
                           "pool &lt;2&gt;, 0.0 s to 9.9 s, fingerprint <code>00ff</code>"}) {
    EXPECT_NE(header.find(text), std::string::npos) << text;
  }
  EXPECT_EQ(header.find("<details"), std::string::npos);
  page.origin.logs.push_back({"another", "", ""});
  html = RenderPage(page);
  EXPECT_NE(html.find("<summary>4 logs</summary>"), std::string::npos);
  EXPECT_EQ(RenderPage({}).find("class=\"origin\""), std::string::npos);
}

TEST(Page, FoldsNotesOfRoutineAndTablesThatAreToBeAskedFor) {
  Page page;
  PageSection& section = page.sections.emplace_back();
  section.notes = {"4 gaps"};
  section.tables = {{"", {{"a"}}, {{{"1"}}}, "More figures"}};
  const std::string html = RenderPage(page);
  EXPECT_NE(html.find("<details class=\"fold\"><summary>More figures</summary>"),
            std::string::npos);
  EXPECT_NE(html.find("<summary>Data</summary>\n<p class=\"text\">4 gaps</p>"), std::string::npos);
}

TEST(Page, KeepsAFoldClosedBelowTheChartsOverTime) {
  Page page = PageOf("x");
  CurvePanel curve;
  curve.y_name = "agreement";
  page.sections[0].folds = {{"What the model leaves", {"Nothing."}, {curve}}};
  const std::string html = RenderPage(page);
  const std::size_t at = html.find("<details class=\"more\"><summary>What the model leaves");
  ASSERT_NE(at, std::string::npos);
  EXPECT_LT(html.find("class=\"chart\""), at);
  EXPECT_LT(at, html.find("<p class=\"text\">Nothing.</p>"));
  EXPECT_LT(html.find("Nothing."), html.find("<figure class=\"scatter curve\""));
}

}  // namespace
}  // namespace fathom
