// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// A chart over time by fingers alone.

#include "fathom/report/page.h"

#include <vector>

#include "headless_browser.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

// A chart from 0 s to 100 s; fingers stand at shares of its width.
TEST(ChartTouch, TwoFingersZoomAndOneMoves) {
  if (Chromium().empty()) GTEST_SKIP() << "chromium is not installed";
  TimePanel motion;
  motion.quantity = "surge velocity";
  for (int i = 0; i <= 100; ++i) motion.time.push_back(i);
  motion.measured = Series{"measured", std::vector<double>(101, 0.0)};
  Page page;
  page.sections = {{"Surge", {}, {}, {motion}, {}, {}}};
  auto findings = FindingsOf(RenderPage(page), R"(
    const plot = drawn[0].group.plots[0];
    const finger = async (id, type, share, pointerType = "touch") => {
      const box = plot.over.getBoundingClientRect();
      plot.over.dispatchEvent(new PointerEvent(type, {pointerId: id, pointerType, bubbles: true,
        clientX: box.left + share * box.width, clientY: box.top + 50}));
      await wait();
    };
    const note = (name) => {
      const {min, max} = plot.scales.x;
      findings[name] = `${min.toFixed(3)}..${max.toFixed(3)}`;
    };
    findings.scrolls = getComputedStyle(plot.over).touchAction;
    await finger(1, "pointerdown", 0.5, "mouse");
    await finger(1, "pointermove", 0.7, "mouse");
    note("mouse");
    await finger(1, "pointerdown", 0.4);
    await finger(2, "pointerdown", 0.6);
    await finger(1, "pointermove", 0.2);
    await finger(2, "pointermove", 0.8);
    note("pinched");
    await finger(2, "pointerup", 0.8);
    note("lifted");
    await finger(1, "pointermove", 0.5);
    note("dragged");
    await finger(1, "pointermove", 9.0);
    note("dragged_far");
    await finger(1, "pointercancel", 9.0);
    await finger(1, "pointermove", 0.1);
    note("after_all");
    await finger(1, "pointerdown", 0.1);
    await finger(2, "pointerdown", 0.9);
    await finger(2, "pointermove", 0.2);
    note("closed");
  )");
  EXPECT_EQ(findings["errors"], "");
  EXPECT_EQ(findings["scrolls"], "pan-y");
  EXPECT_EQ(findings["mouse"], "0.000..100.000");
  // 40 s and 60 s lie at 0.2 and 0.8: 20 s take 0.6 of the width.
  EXPECT_EQ(findings["pinched"], "33.333..66.667");
  EXPECT_EQ(findings["lifted"], "33.333..66.667");
  // 40 s lies at 0.5.
  EXPECT_EQ(findings["dragged"], "23.333..56.667");
  EXPECT_EQ(findings["dragged_far"], "0.000..33.333");
  EXPECT_EQ(findings["after_all"], "0.000..33.333");
  EXPECT_EQ(findings["closed"], "0.000..100.000");
}

}  // namespace
}  // namespace fathom
