// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Pages as the tools write them, in a browser.

#include "page_layout.h"

#include <filesystem>
#include <string>
#include <vector>

#include "filmed_minute.h"
#include "headless_browser.h"
#include "mistakes.h"
#include "run_tool.h"
#include "saved_files.h"
#include "small_log.h"
#include "sound_log.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using Path = std::filesystem::path;

const std::string kPoolRun = FATHOM_DATA_DIR "/flatfish";

class PageLayout : public testing::Test {
 protected:
  void SetUp() override {
    if (Chromium().empty()) GTEST_SKIP() << "chromium is not installed";
  }

  // The page that a tool writes.
  std::string PageOf(const std::string& tool,
                     std::vector<std::string> arguments,
                     int exit_code = 0) {
    const Path page = folder_ / "page.html";
    arguments.push_back(Flag("report", page));
    const ToolRun run = RunToolBinary(tool, arguments);
    EXPECT_EQ(run.exit_code, exit_code) << run.err;
    return TextOf(page);
  }

  static void ExpectThatItFits(const std::string& html) {
    const std::vector<PageLook> looks = {{.width = 1400},
                                         {.width = 800},
                                         {.width = 390},
                                         {.width = 390, .is_dark = true},
                                         {.width = kPaperWidth, .is_printed = true}};
    const auto faults = FaultsOf(html, looks);
    for (std::size_t k = 0; k < looks.size(); ++k) {
      for (const auto& [what, found] : faults[k]) {
        EXPECT_EQ(found, "") << what << " at " << looks[k].width << " px"
                             << (looks[k].is_printed ? " on paper" : "")
                             << (looks[k].is_dark ? " in the dark" : "");
      }
    }
  }

  const Path folder_ = EmptyTestFolder();
};

// What the other tests rely on.
TEST_F(PageLayout, ShowsWhatIsWrongWithIt) {
  const auto faults = FaultsOf(
      R"(<!doctype html><html><head></head><body><div style="width: 900px">wide</div>)"
      R"(<figure class="bare"></figure><script>console.error("lost");</script></body></html>)",
      {{.width = 1400}, {.width = 390}});
  EXPECT_EQ(faults[0].at("overflow"), "");
  EXPECT_THAT(faults[1].at("overflow"), testing::HasSubstr("at first the page: 9"));
  for (const auto& fault : faults) {
    EXPECT_EQ(fault.at("errors"), "lost");
    EXPECT_EQ(fault.at("unlabelled"), "bare");
  }
}

TEST_F(PageLayout, OfAComparisonFits) {
  const std::string page =
      PageOf("fathom_compare", {"--log=" + kPoolRun, "--dofs=surge,heave,yaw", "--json="});
  ExpectThatItFits(page);
  const std::string header = page.substr(0, page.find("</header>"));
  EXPECT_THAT(header, testing::HasSubstr("<code>fathom_compare --log=" + kPoolRun));
  EXPECT_THAT(header,
              testing::ContainsRegex("flatfish_table1, 0.0 s to 299.9 s, fingerprint "
                                     "<code>[0-9a-f]{16}</code>"));
}

TEST_F(PageLayout, OfAComparisonOfStructuresFits) {
  ExpectThatItFits(PageOf(
      "fathom_compare",
      {"--log=" + kPoolRun, "--dofs=surge", "--structures=diagonal", "--families=output_error"}));
}

TEST_F(PageLayout, OfADiagnosisFits) {
  ExpectThatItFits(PageOf("fathom_diagnose", {"--log=" + kPoolRun, "--dof=surge"}));
}

// With a picture of a sensor that is stuck, and one of the command's delay.
TEST_F(PageLayout, OfACheckFits) {
  LogNumbers log = SoundLog(folder_);
  GetStuck(&log);
  for (double& t : log.time) t += 3.0;
  Write(log, folder_ / "log");
  const std::string page = PageOf("fathom_check", {Flag("log", folder_ / "log")}, 2);
  EXPECT_THAT(page, testing::HasSubstr("stuck values</h2>"));
  EXPECT_THAT(page, testing::HasSubstr("command delay</h2>"));
  ExpectThatItFits(page);
}

TEST_F(PageLayout, OfACheckOfSeveralLogsFits) {
  std::vector<std::string> arguments;
  LogNumbers log = SoundLog(folder_);
  for (const char* dive : {"dive_1", "dive_2", "dive_3"}) {
    Write(log, folder_ / dive);
    arguments.push_back(Flag("log", folder_ / dive));
    ScaleForce(1.01, &log);  // the same data twice would be refused
  }
  ExpectThatItFits(PageOf("fathom_check", arguments));
}

TEST_F(PageLayout, OfARefinementFits) {
  const Path log = SynthesizeMinute(folder_ / "log", "wall.yaml", 40.0, 1);
  ExpectThatItFits(PageOf("fathom_refine", {Flag("log", log), "--dof=surge"}));
}

TEST_F(PageLayout, OfAnArchiveFits) {
  for (const char* dive : {"dive_1", "dive_2"}) WriteSmallLog(folder_ / "archive" / dive / "run");
  ExpectThatItFits(
      PageOf("fathom_batch",
             {Flag("archive", folder_ / "archive"), Flag("results", folder_ / "results.sqlite")}));
}

}  // namespace
}  // namespace fathom
