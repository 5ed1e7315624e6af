// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The data behind a chart, saved by a reader of the page.

#include "fathom/report/page.h"

#include <cmath>
#include <string>

#include "headless_browser.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

// Reads what the first button saves, one line after another. It waits for nothing: reading a blob
// asks another process, which a browser with virtual time does not wait for.
const std::string kSave = R"(
  let saved, file;
  window.Blob = function(parts) { saved = parts.join(""); };
  URL.createObjectURL = () => "#";
  HTMLAnchorElement.prototype.click = function() { file = this.download; };
  document.querySelector(".save").click();
  findings.csv = saved.trim().split("\n").join("|");
  findings.file = file;
)";

TEST(Csv, HoldsWhatATimeChartDrawsByItsTrueTime) {
  if (Chromium().empty()) GTEST_SKIP() << "chromium is not installed";
  TimePanel motion;
  motion.quantity = "surge velocity";
  motion.unit = "m/s";
  motion.time = {2e9 + 0.25, 2e9 + 0.5, 2e9 + 0.5, 2e9 + 9.0};
  motion.measured = Series{"measured", {0.1, 0.2, std::nan(""), std::nan("")}};
  motion.responses = {{"a, \"b\"", {1.5, -1.0, std::nan(""), 2.0}}};
  Page page;
  page.title = "pool 3";
  page.sections = {{"Surge", {}, {}, {motion}, {}, {}}};
  auto findings = FindingsOf(RenderPage(page), kSave);
  EXPECT_EQ(findings["errors"], "");
  EXPECT_EQ(findings["csv"],
            "time [s],measured [m/s],\"a, \"\"b\"\" [m/s]\"|2000000000.25,0.1,1.5|"
            "2000000000.5,0.2,-1|2000000009,,2");
  EXPECT_EQ(findings["file"], "pool_3_surge_velocity_over_time.csv");
}

TEST(Csv, HoldsThePointsOfAScatterChart) {
  if (Chromium().empty()) GTEST_SKIP() << "chromium is not installed";
  Page page;
  page.title = "pool 3";
  PageSection& section = page.sections.emplace_back();
  section.scatter_panels = {{"command",
                             "N",
                             "missing",
                             "N",
                             {1.0, 2.0, std::nan("")},
                             {0.5, -0.25, 1.0},
                             {0.125, std::nan(""), 1.0},
                             "explained",
                             ""}};
  auto findings = FindingsOf(RenderPage(page), kSave);
  EXPECT_EQ(findings["errors"], "");
  EXPECT_EQ(findings["csv"], "command [N],missing [N],explained [N]|1,0.5,0.125|2,-0.25,");
}

TEST(Csv, HoldsTheCurveAndTheBandOfACurveChart) {
  if (Chromium().empty()) GTEST_SKIP() << "chromium is not installed";
  Page page;
  page.title = "pool 3";
  CurvePanel& panel = page.sections.emplace_back().curve_panels.emplace_back();
  panel.x_name = "lag";
  panel.x_unit = "s";
  panel.y_name = "agreement";
  panel.x = {0.1, 0.2};
  panel.y = {0.75, std::nan("")};
  panel.low = {-0.5, -0.5};
  panel.high = {0.5, 0.5};
  panel.band_name = "white noise";
  auto findings = FindingsOf(RenderPage(page), kSave);
  EXPECT_EQ(findings["errors"], "");
  EXPECT_EQ(findings["csv"],
            "lag [s],agreement,\"white noise, low\",\"white noise, high\"|0.1,0.75,-0.5,0.5");
  EXPECT_EQ(findings["file"], "pool_3_agreement_over_lag_s_.csv");
}

// A long name of the x-axis reaches as far as the button, which stands below it.
TEST(Csv, IsSavedFromBelowTheNameOfTheAxis) {
  if (Chromium().empty()) GTEST_SKIP() << "chromium is not installed";
  Page page;
  page.title = "spiral";
  CurvePanel& panel = page.sections.emplace_back().curve_panels.emplace_back();
  panel.x_name = "rudder, to starboard";
  panel.x_unit = "deg";
  panel.y_name = "steady yaw rate";
  panel.x = {-25.0, 25.0};
  panel.y = {-1.0, 1.0};
  auto findings = FindingsOf(RenderPage(page), R"(
  const names = [...document.querySelectorAll(".scatter text")].map((one) => one.getBoundingClientRect().bottom);
  findings.below = document.querySelector(".save").getBoundingClientRect().top - Math.max(...names);
)");
  EXPECT_EQ(findings["errors"], "");
  EXPECT_GT(std::stod(findings["below"]), 0.0);
}

}  // namespace
}  // namespace fathom
