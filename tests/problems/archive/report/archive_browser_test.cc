// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/report/archive_page.h"

#include <algorithm>
#include <limits>
#include <map>
#include <string>

#include "example_archive.h"
#include "headless_browser.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using testing::HasSubstr;

class ArchiveInBrowser : public testing::Test {
 protected:
  void SetUp() override {
    if (Chromium().empty()) GTEST_SKIP() << "chromium is not installed";
  }

  std::map<std::string, std::string> Findings(const ArchiveReport& report, const Window& window) {
    auto findings = FindingsIn(DomOf(RenderArchivePage(report), window));
    EXPECT_FALSE(findings.empty());
    EXPECT_EQ(findings.count("failed"), 0u) << findings["failed"];
    EXPECT_EQ(findings["errors"], "0") << findings["error_texts"];
    EXPECT_EQ(findings["resources_loaded"], "0");
    EXPECT_EQ(findings["unlabelled"], "0");
    for (const char* when : {"overflow", "overflow_opened", "overflow_at_end"}) {
      EXPECT_EQ(findings[when], "0") << when << " at " << window.width << " px";
    }
    return findings;
  }
};

TEST_F(ArchiveInBrowser, DrawsWhatTheDivesSay) {
  auto findings = Findings(ExampleArchive(), {.width = 1400});
  // Four parameters of three DOFs. The payload is a step in each inertia; one fit is marked as an
  // outlier; one value and the interval of another lie outside of their charts.
  EXPECT_EQ(findings["charts"], "12");
  EXPECT_EQ(findings["charts_drawn"], "12");
  EXPECT_EQ(findings["borders"], "3");
  EXPECT_EQ(findings["diamonds"], "1");
  EXPECT_EQ(findings["arrows"], "2");
  EXPECT_EQ(findings["matrices"], "3");
  EXPECT_GT(std::stoi(findings["cells"]), 20);
  // Every fifth dive of 30 was not diagnosed, in none of three DOFs.
  EXPECT_GE(std::stoi(findings["not_diagnosed_cells"]), 18);
  const DiveFitRow first = ExampleArchive().tables.dive_fits.front();
  EXPECT_THAT(findings["read_out"], HasSubstr("dive-001: "));
  EXPECT_NEAR(std::stod(findings["read_out"].substr(10)), first.value, 0.06);
}

TEST_F(ArchiveInBrowser, FiltersSortsAndOpensDives) {
  auto findings = Findings(ExampleArchive(), {.width = 800});
  EXPECT_EQ(findings["rows"], "30");
  EXPECT_EQ(findings["worst_dive"], "dive-009");  // two refused logs
  EXPECT_THAT(findings["logs_opened"], HasSubstr("the stamps go back 0.8 s at line 2044"));
  EXPECT_THAT(findings["logs_opened"], HasSubstr("dives/dive-009/log-4"));
  EXPECT_EQ(findings["largest_score"], "dive-018");  // four times the others' errors
  EXPECT_EQ(findings["sorted"], "descending");
  EXPECT_NE(findings["smallest_score"], "dive-018");
  EXPECT_EQ(findings["rows_crashed"], "1");
  EXPECT_EQ(findings["rows_all"], "30");
}

TEST_F(ArchiveInBrowser, ComparesTheDivesToEitherSideOfAStep) {
  auto findings = Findings(ExampleArchive(), {.width = 1400});
  EXPECT_EQ(findings["compared"], "dive-012 | dive-013");
  for (const char* dof : {"surge inertia", "sway inertia", "heave inertia"}) {
    EXPECT_THAT(findings["differences"], HasSubstr(dof));
  }
  EXPECT_EQ(findings["differences_of_same"], "0");
}

// Sixteen charts of a dot each told nothing that a row does not.
TEST_F(ArchiveInBrowser, WritesWhatOneDiveAloneTellsInARow) {
  ArchiveReport report = ExampleArchive({20, 2});
  auto& fits = report.tables.dive_fits;
  std::erase_if(fits, [](const DiveFitRow& row) {
    return row.dive != "dive-001" && row.parameter == "inertia" && row.dof == "surge";
  });
  report.tables.changes.clear();
  auto findings = Findings(report, {.width = 1400});
  EXPECT_EQ(findings["charts"], "11");
  EXPECT_EQ(findings["charts_drawn"], "11");
  EXPECT_THAT(findings["lone_rows"], testing::MatchesRegex("inertia.+ kg.*dive-001"));
}

TEST_F(ArchiveInBrowser, FitsAPhone) {
  auto findings = Findings(ExampleArchive(), {.width = 390});
  EXPECT_LE(std::stoi(findings["width"]), 390);
  EXPECT_EQ(findings["charts_drawn"], "12");
}

// From 901 px on the dives are a table, not cards. Its last column was cut.
TEST_F(ArchiveInBrowser, ShowsEveryColumnOfTheDives) {
  for (const int width : {901, 1000, 1100, 1250}) Findings(ExampleArchive(), {.width = width});
}

TEST_F(ArchiveInBrowser, FitsAPhoneWithNamesThatKnowNoEnd) {
  ArchiveReport report = ExampleArchive({20, 2});
  const std::string name(120, 'x');
  report.archive = report.origin.command = name;
  report.dives.front() = name;
  for (LogRow& log : report.tables.logs) {
    if (log.dive == "dive-001") log.dive = log.message = name;
    log.vehicle = name;
  }
  for (DiveFitRow& row : report.tables.dive_fits) {
    if (row.dive == "dive-001") row.dive = name;
    row.vehicle = name;
  }
  for (CauseRow& row : report.tables.causes) row.effect = name;
  for (ChangeRow& row : report.tables.changes) row.text = name;
  Findings(report, {.width = 390});
  Findings(report, {.width = 800});
  Findings(report, {.width = 1400});
}

TEST_F(ArchiveInBrowser, StandsWithoutAnyLog) { Findings({}, {}); }

TEST_F(ArchiveInBrowser, RunsNoScriptThatATextSmugglesIn) {
  const std::string text = "<img src=x onerror=\"document.body.id='owned'\">";
  ArchiveReport report = ExampleArchive({20, 1});
  report.dives.front() = report.archive = text;
  for (LogRow& log : report.tables.logs) log.message = text;
  for (FindingRow& row : report.tables.findings) row.text = text;
  for (auto& [key, page] : report.pages) page = "javascript:document.body.id='owned'";
  const std::string dom = DomOf(RenderArchivePage(report), {});
  ASSERT_NE(dom.find("id=\"selftest\""), std::string::npos);
  EXPECT_EQ(dom.find("<body id=\"owned\""), std::string::npos);
  EXPECT_EQ(FindingsIn(dom)["first_address"], "javascript%3Adocument.body.id%3D%27owned%27");
}

std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at)) {
    text.replace(at, from.size(), to);
  }
  return text;
}

// The style of print on a screen that is as wide as A4 between its margins.
TEST_F(ArchiveInBrowser, CutsNoColumnInPrint) {
  const std::string html = RenderArchivePage(ExampleArchive());
  ASSERT_THAT(html, HasSubstr("@media print"));
  const std::string printed =
      Replaced(Replaced(html, "@media print", "@media all"), "@media screen", "@media speech");
  auto findings = FindingsIn(DomOf(printed, {.width = 700}));
  EXPECT_EQ(findings["overflow"], "0");
  EXPECT_EQ(findings["errors"], "0") << findings["error_texts"];
  EXPECT_EQ(findings["controls_in_sight"], "0");
  // On a screen they are there: the filter, two dives to choose.
  EXPECT_GE(std::stoi(FindingsIn(DomOf(html, {}))["controls_in_sight"]), 3);
}

TEST_F(ArchiveInBrowser, PrintsAsAFile) {
  const std::string pdf = PrintOf(RenderArchivePage(ExampleArchive()));
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
}

// 2000 dives of 5 logs, 3 DOFs and 4 parameters. The best of three, for other work on the machine.
// A machine that takes over a third of a second to read the file alone is given three times as
// long.
TEST_F(ArchiveInBrowser, OpensThousandsOfDivesWithinASecond) {
  const ArchiveReport report = ExampleArchive({2000, 5});
  double share = std::numeric_limits<double>::infinity();  // of the time that it may take
  for (int i = 0; i < 3 && !(share < 1.0); ++i) {
    auto findings = Findings(report, {.width = 1400, .has_real_time = true});
    EXPECT_EQ(findings["rows"], "100");
    EXPECT_EQ(findings["rows_all"], "2000");
    const double read = std::stod(findings["read_ms"]), drawn = std::stod(findings["drawn_ms"]);
    share = std::min(share, drawn / std::max(1000.0, 3.0 * read));
  }
  EXPECT_LT(share, 1.0);
}

}  // namespace
}  // namespace fathom
