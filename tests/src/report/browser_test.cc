// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/report/page.h"

#include <array>
#include <cmath>
#include <sstream>
#include <string>

#include "example_page.h"
#include "headless_browser.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using testing::HasSubstr;

TEST(Browser, DrawsTogglesZoomsAndReadsOutTheCharts) {
  if (Chromium().empty()) GTEST_SKIP() << "chromium is not installed";
  const Page page = ExamplePage();
  auto findings = FindingsIn(DomOf(page));
  ASSERT_EQ(findings.count("failed"), 0u) << findings["failed"];
  ASSERT_FALSE(findings.empty());
  EXPECT_EQ(findings["errors"], "0") << findings["error_texts"];
  EXPECT_EQ(findings["resources_loaded"], "0");

  // Three sections of response, residual and command.
  EXPECT_EQ(findings["charts"], "9");
  EXPECT_EQ(findings["charts_drawn"], "9");

  // The last curve of the first panel goes and comes back.
  EXPECT_GT(std::stoi(findings["ink_before"]), 100);
  EXPECT_GT(std::stoi(findings["residual_ink_before"]), 100);
  EXPECT_EQ(findings["ink_hidden"], "0");
  EXPECT_EQ(findings["residual_ink_hidden"], "0");
  EXPECT_EQ(findings["pressed_hidden"], "false");
  EXPECT_EQ(findings["ink_after"], findings["ink_before"]);

  // The legend shows the measured value and a residual at the stamp below the cursor, which stands
  // in the middle of a chart from 0 s to 299.9 s. A pixel is 0.3 s wide, the stamps are 0.1 s
  // apart.
  const std::string read_out = findings["read_out"];
  const std::size_t at = read_out.find("t = ");
  ASSERT_NE(at, std::string::npos) << read_out;
  const double time = std::stod(read_out.substr(at + 4));
  EXPECT_NEAR(time, 149.95, 0.5);
  const TimePanel& panel = page.sections[0].time_panels[0];
  const auto index = static_cast<std::size_t>(std::lround(10.0 * time));
  const double measured = panel.measured->values[index];
  EXPECT_THAT(read_out, HasSubstr(fmt::format("{:.4f} m/s", measured)));
  // A residual has the decimals of the largest residual: 0.1.
  EXPECT_THAT(read_out,
              HasSubstr(fmt::format("Δ {:.4f}", measured - panel.responses[1].values[index])));
  EXPECT_EQ(findings["charts_with_cursor"], "3");

  // Dragged from a quarter to the half of the width.
  double from = 0.0;
  double to = 0.0;
  std::array<std::string, 3> zooms;
  std::istringstream(findings["zoom"]) >> zooms[0] >> zooms[1] >> zooms[2];
  ASSERT_EQ(std::sscanf(zooms[0].c_str(), "%lf..%lf", &from, &to), 2) << findings["zoom"];
  EXPECT_NEAR(from, 74.975, 0.5);
  EXPECT_NEAR(to, 149.95, 0.5);
  EXPECT_EQ(zooms[1], zooms[0]);
  EXPECT_EQ(zooms[2], zooms[0]);
  EXPECT_EQ(findings["reset_shown"], "true");
  const std::string all = "0.000..299.900 0.000..299.900 0.000..299.900";
  EXPECT_EQ(findings["zoom_after_double_click"], all);
  EXPECT_EQ(findings["zoom_again"], findings["zoom"]);
  EXPECT_EQ(findings["zoom_after_reset"], all);
  EXPECT_EQ(findings["reset_hidden"], "true");
  EXPECT_EQ(findings["zoom_from_last"], "0.000..1.000 0.000..1.000 0.000..1.000");
}

TEST(Browser, RunsNoScriptThatATextSmugglesIn) {
  if (Chromium().empty()) GTEST_SKIP() << "chromium is not installed";
  const std::string text =
      "</script><script>document.body.id='owned'</script><img src=x "
      "onerror=\"document.body.id='owned'\">";
  Page page;
  page.title = text;
  page.lead = {text};
  TimePanel panel;
  panel.quantity = panel.unit = text;
  panel.time = {0.0, 1.0};
  panel.measured = Series{text, {0.0, 1.0}, text};
  panel.responses = {{text + "2", {0.0, 0.5}, text}};
  page.sections.push_back({text, {}, {}, {panel}, {{text, text, {{text, 1.0, 0.1}}}}, {}});
  const std::string dom = DomOf(page);
  ASSERT_NE(dom.find("id=\"selftest\""), std::string::npos);
  EXPECT_EQ(dom.find("<body id=\"owned\""), std::string::npos);
  EXPECT_EQ(FindingsIn(dom)["errors"], "0");
  EXPECT_EQ(FindingsIn(dom)["charts_drawn"], "2");
}

// A low chart has 100 px for it.
TEST(Browser, MakesTheNameOfAnAxisSmallerWhereItWouldBeCutOff) {
  if (Chromium().empty()) GTEST_SKIP() << "chromium is not installed";
  auto findings = FindingsOf(RenderPage(ExamplePage()), R"(
    const pen = document.createElement("canvas").getContext("2d");
    const name = "a surge command of some length [N]";
    pen.font = fontWithin(name, 100);
    findings.fits = pen.measureText(name).width <= 100;
    findings.is_used = pen.measureText(name).width > 75;
    findings.short = fontWithin("x [m]", 100) === FONT;
  )");
  EXPECT_EQ(findings["errors"], "");
  EXPECT_EQ(findings["fits"], "true");
  EXPECT_EQ(findings["is_used"], "true");
  EXPECT_EQ(findings["short"], "true");
}

}  // namespace
}  // namespace fathom
