// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Curves that are pale until they are asked for.

#include "fathom/report/page.h"

#include "headless_browser.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

// One full curve (the first colour of the palette, blue) and a faded one (the second, red).
Page PageWithAFadedCurve() {
  TimePanel motion;
  motion.quantity = "surge velocity";
  for (int i = 0; i < 100; ++i) motion.time.push_back(i);
  motion.measured = Series{"measured", std::vector<double>(100, 0.0)};
  motion.responses = {{"best", std::vector<double>(100, 1.0)},
                      {"other", std::vector<double>(100, 2.0)}};
  motion.responses[1].is_faded = true;
  Page page;
  page.sections = {{"Surge", {}, {}, {motion}, {}, {}}};
  return page;
}

TEST(FadedCurves, ComeOutWhenAskedForAndPointedAt) {
  if (Chromium().empty()) GTEST_SKIP() << "chromium is not installed";
  auto findings = FindingsOf(RenderPage(PageWithAFadedCurve()), R"(
    const [motion, residual] = document.querySelectorAll("canvas");
    const buttons = document.querySelectorAll(".legend button");
    const look = async (name) => {
      await wait();
      findings[name] = inkOf(motion, "#d55e00") > 100 && inkOf(residual, "#d55e00") > 100;
      findings[`${name}_pressed`] = buttons[2].getAttribute("aria-pressed");
    };
    findings.best = inkOf(motion, "#0072b2") > 100;
    await look("at_first");
    buttons[2].click();
    await look("clicked");
    buttons[2].click();
    await look("clicked_again");
    buttons[2].dispatchEvent(new MouseEvent("mouseenter"));
    await look("hovered");
    buttons[2].dispatchEvent(new MouseEvent("mouseleave"));
    await look("left");
    buttons[2].focus({focusVisible: true});
    await look("focused");
    buttons[2].blur();
    await look("blurred");
  )");
  EXPECT_EQ(findings["errors"], "");
  EXPECT_EQ(findings["best"], "true");
  EXPECT_EQ(findings["at_first"], "false");
  EXPECT_EQ(findings["at_first_pressed"], "false");
  EXPECT_EQ(findings["clicked"], "true");
  EXPECT_EQ(findings["clicked_pressed"], "true");
  EXPECT_EQ(findings["clicked_again"], "false");
  EXPECT_EQ(findings["hovered"], "true");
  EXPECT_EQ(findings["left"], "false");
  EXPECT_EQ(findings["focused"], "true");
  EXPECT_EQ(findings["blurred"], "false");
}

}  // namespace
}  // namespace fathom
