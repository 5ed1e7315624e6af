// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Runs with silence between them, drawn next to one another.

#include "fathom/report/page.h"

#include <cmath>
#include <string>

#include "headless_browser.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

// Runs of 60 s, the first from 0 s, and so much silence between them.
Page PageOfRuns(int num_runs, double silence) {
  TimePanel motion;
  motion.quantity = "surge velocity";
  motion.measured = Series{"measured", {}};
  for (int run = 0; run < num_runs; ++run) {
    const double start = run * (60.0 + silence);
    for (int i = 0; i <= 60; ++i) {
      motion.time.push_back(start + i);
      motion.measured->values.push_back(0.1 * run);
    }
    motion.time.push_back(start + 60.0);
    motion.measured->values.push_back(std::nan(""));
  }
  motion.held_out = {{60.0 + silence, 120.0 + silence}};
  Page page;
  page.sections = {{"Surge", {}, {}, {motion}, {}, {}}};
  return page;
}

// The axis at rest, and what the first tenth of it shows.
const std::string kLook = R"(
  const {group, panel, plots: [plot]} = drawn[0];
  const ticks = () => {
    const {min, max} = plot.scales.x;
    const step = plot.axes[0]._found[0];
    return plot.axes[0].values(plot, plot.axes[0].splits(plot, 0, min, max, step)).join(" ");
  };
  findings.cuts = group.cuts.length;
  findings.whole = (group.last - group.first).toFixed(3);
  findings.runs = group.cuts.map(({from}, i) => (placeOf(group.cuts, from) - (i ? placeOf(group.cuts, group.cuts[i - 1].to) : 0)).toFixed(3)).join(" ");
  findings.back = Math.max(...panel.time.map((time) => Math.abs(timeOf(group.cuts, placeOf(group.cuts, time)) - time))) < 1e-9;
  findings.hint = document.body.innerText.includes("Silences are cut out");
  if (group.cuts.length) {
    findings.held_out = panel.held_out[0].map((one) => timeOf(group.cuts, one).toFixed(3)).join(" ");
    findings.ticks = ticks();
  }
)";

TEST(TimeCuts, PutRunsNextToOneAnotherWithTicksOfTheTrueTime) {
  if (Chromium().empty()) GTEST_SKIP() << "chromium is not installed";
  auto findings = FindingsOf(RenderPage(PageOfRuns(4, 300.0)), kLook);
  EXPECT_EQ(findings["errors"], "");
  EXPECT_EQ(findings["cuts"], "3");
  // 4 runs of 60 s and 3 breaks of a tenth of a fifth of 240 s each: 240 + 3 * 4.8.
  EXPECT_EQ(findings["whole"], "254.400");
  EXPECT_EQ(findings["runs"], "60.000 60.000 60.000");
  EXPECT_EQ(findings["back"], "true");
  EXPECT_EQ(findings["held_out"], "360.000 420.000");
  EXPECT_EQ(findings["hint"], "true");
  // The runs begin at 0, 360, 720 and 1080 s.
  EXPECT_EQ(findings["ticks"], "0 20 40 60 380 400 420 740 760 780 1,100 1,120 1,140");
}

TEST(TimeCuts, LeaveShortSilencesAlone) {
  if (Chromium().empty()) GTEST_SKIP() << "chromium is not installed";
  auto findings = FindingsOf(RenderPage(PageOfRuns(4, 20.0)), kLook);
  EXPECT_EQ(findings["errors"], "");
  EXPECT_EQ(findings["cuts"], "0");
  EXPECT_EQ(findings["whole"], "300.000");
  EXPECT_EQ(findings["hint"], "false");
}

TEST(TimeCuts, GiveManyRunsMoreRoomThanTheBreaks) {
  if (Chromium().empty()) GTEST_SKIP() << "chromium is not installed";
  auto findings = FindingsOf(RenderPage(PageOfRuns(72, 600.0)), kLook);
  EXPECT_EQ(findings["errors"], "");
  EXPECT_EQ(findings["cuts"], "71");
  // The breaks take a fifth of the 72 runs of 60 s.
  EXPECT_EQ(findings["whole"], "5184.000");
}

}  // namespace
}  // namespace fathom
