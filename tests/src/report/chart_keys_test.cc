// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// A chart over time by the keyboard alone.

#include "fathom/report/page.h"

#include <map>
#include <string>

#include "headless_browser.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

// What each key shows of a chart from 0 s to 100 s, as "from..to".
std::map<std::string, std::string> StretchesAfterKeys() {
  TimePanel motion;
  motion.quantity = "surge velocity";
  for (int i = 0; i <= 100; ++i) motion.time.push_back(i);
  motion.measured = Series{"measured", std::vector<double>(101, 0.0)};
  Page page;
  page.sections = {{"Surge", {}, {}, {motion}, {}, {}}};
  return FindingsOf(RenderPage(page), R"(
    const frame = document.querySelector(".plots");
    const press = async (name, key, options = {}) => {
      frame.dispatchEvent(new KeyboardEvent("keydown", {key, bubbles: true, cancelable: true, ...options}));
      await wait();
      const {min, max} = drawn[0].group.plots[0].scales.x;
      findings[name] = `${min}..${max}`;
    };
    frame.focus({focusVisible: true});
    findings.has_focus = document.activeElement === frame;
    findings.ring = getComputedStyle(frame).outlineStyle;
    findings.label = frame.getAttribute("aria-label");
    await press("in", "+");
    await press("in_again", "=");
    await press("right", "ArrowRight");
    await press("with_control", "ArrowRight", {ctrlKey: true});
    await press("other_key", "x");
    for (let i = 0; i < 9; ++i) await press("far_right", "ArrowRight");
    findings.reset_shown = !document.querySelector(".reset").hidden;
    await press("out", "-");
    await press("zero", "0");
    await press("left_of_all", "ArrowLeft");
    await press("out_of_all", "-");
    await press("in", "+");
    await press("escape", "Escape");
    findings.reset_shown_at_end = !document.querySelector(".reset").hidden;
  )");
}

TEST(ChartKeys, ZoomAboutTheMiddleMoveAndReset) {
  if (Chromium().empty()) GTEST_SKIP() << "chromium is not installed";
  auto findings = StretchesAfterKeys();
  EXPECT_EQ(findings["errors"], "");
  EXPECT_EQ(findings["has_focus"], "true");
  EXPECT_EQ(findings["ring"], "solid");
  EXPECT_EQ(findings["label"], "surge velocity over time: + and - zoom, arrows move, 0 resets");
  EXPECT_EQ(findings["in"], "25..75");
  EXPECT_EQ(findings["in_again"], "37.5..62.5");
  EXPECT_EQ(findings["right"], "43.75..68.75");
  EXPECT_EQ(findings["with_control"], findings["right"]);
  EXPECT_EQ(findings["other_key"], findings["right"]);
  EXPECT_EQ(findings["far_right"], "75..100");
  EXPECT_EQ(findings["reset_shown"], "true");
  EXPECT_EQ(findings["out"], "50..100");
  EXPECT_EQ(findings["zero"], "0..100");
  EXPECT_EQ(findings["left_of_all"], "0..100");
  EXPECT_EQ(findings["out_of_all"], "0..100");
  EXPECT_EQ(findings["escape"], "0..100");
  EXPECT_EQ(findings["reset_shown_at_end"], "false");
}

}  // namespace
}  // namespace fathom
