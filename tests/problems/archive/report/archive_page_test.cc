// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/report/archive_page.h"

#include "fathom/archive/report/log_states.h"

#include <string>
#include <tuple>

#include "example_archive.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using testing::HasSubstr;
using testing::Not;

// The part of the page that a reader without a script sees.
std::string WithoutScripts(const std::string& html) {
  return html.substr(html.find("<body>"), html.find("<script") - html.find("<body>"));
}

TEST(ArchivePage, SaysWhatChangedBeforeAllElse) {
  const std::string body = WithoutScripts(RenderArchivePage(ExampleArchive()));
  const auto payload = body.find("From dive-013 on the vehicle is 14 kg heavier (± 2) in surge");
  const auto fouling = body.find("the quadratic damping of surge grows by 33 % (± 4): fouling.");
  const auto logs = body.find("120 logs in 30 dives: 111 gave a model (110 ok, 1 partial)");
  ASSERT_NE(payload, std::string::npos);
  EXPECT_LT(payload, fouling);
  ASSERT_LT(fouling, logs);
  ASSERT_NE(logs, std::string::npos);
  EXPECT_LT(logs, body.find("<h2>"));
}

TEST(ArchivePage, NamesDivesWithoutAJointFit) {
  ArchiveReport report = ExampleArchive();
  EXPECT_THAT(WithoutScripts(RenderArchivePage(report)),
              HasSubstr("Of 1 dive no DOF has a usable joint fit: dive-007 (surge: no stretch is "
                        "excited).</p>"));
  for (DiveFitRow& row : report.tables.dive_fits) row.usable = true;
  EXPECT_THAT(WithoutScripts(RenderArchivePage(report)),
              Not(HasSubstr("no DOF has a usable joint fit")));
}

TEST(ArchivePage, NamesWhatIsNearlyALog) {
  ArchiveReport report = ExampleArchive();
  EXPECT_THAT(WithoutScripts(RenderArchivePage(report)), Not(HasSubstr("nearly")));
  report.nearly_logs = {{"a<b.csv", "its first line does not name t, tau and v"}};
  EXPECT_THAT(WithoutScripts(RenderArchivePage(report)),
              HasSubstr("nearly a log: a&lt;b.csv (its first line does not name t, tau and v)."));
}

TEST(ArchivePage, ListsEveryLogThatGaveNoModelWithItsReason) {
  const ArchiveReport report = ExampleArchive();
  const std::string body = WithoutScripts(RenderArchivePage(report));
  for (const LogRow& log : report.tables.logs) {
    const std::string item = "<li>" + log.path + "</li>";
    if (GivesModel(log.status)) {
      EXPECT_THAT(body, Not(HasSubstr(item)));
    } else {
      EXPECT_THAT(body, HasSubstr(item));
      EXPECT_THAT(body, HasSubstr("<h3>" + StateText(log.status) + " <span>"));
    }
  }
  EXPECT_THAT(body, HasSubstr("fathom_identify: signal 11"));
}

TEST(ArchivePage, ShowsCoupledModelsWhereThereAreSome) {
  ArchiveReport report = ExampleArchive();
  EXPECT_THAT(RenderArchivePage(report), Not(HasSubstr("#coupled")));
  FitRow fit = {.log = "dive-001/<a>",
                .dof = "surge,yaw",
                .family = "coupled",
                .source = "thruster",
                .usable = true,
                .parameter = "inertia.surge",
                .unit = "kg",
                .message = ""};
  report.tables.fits.push_back(fit);
  fit.parameter = "inertia.yaw";
  report.tables.fits.push_back(fit);
  report.tables.verdicts.push_back({fit.log, fit.dof, "explained", "Port is weak.", ""});
  for (const auto& [entry, value, std, unit] : {std::tuple{"thrust_gain.port", 0.8, 0.01, "1"},
                                                std::tuple{"inertia.sway.yaw", 1.6, 0.2, "kg m"}}) {
    report.tables.causes.push_back({.log = fit.log,
                                    .dof = fit.dof,
                                    .effect = entry,
                                    .parameter = entry,
                                    .value = value,
                                    .std = std,
                                    .unit = unit});
  }
  FitRow none = fit;
  none.log = "dive-002/b";
  none.usable = false;
  none.parameter = "";
  none.message = "no diagnosis: yaw < 0.";
  report.tables.fits.push_back(none);
  report.pages[{fit.log, fit.dof}] = "p/x.html";
  const std::string body = WithoutScripts(RenderArchivePage(report));
  EXPECT_THAT(body, HasSubstr("<a href=\"#coupled\">"));
  EXPECT_THAT(body,
              HasSubstr("<tr><td>dive-001/&lt;a&gt;</td><td><a href=\"p/x.html\">surge,yaw</a></td>"
                        "<td>thruster</td><td>explained</td>"
                        "<td>thrust_gain.port 0.800 ± 0.010, inertia.sway.yaw 1.60 ± 0.20 kg m</td>"
                        "</tr>\n<tr><td>dive-002/b</td><td>surge,yaw</td><td>–</td>"
                        "<td>no usable fit</td><td>no diagnosis: yaw &lt; 0.</td></tr>\n"));
}

TEST(ArchivePage, BeginsWithWhereItComesFrom) {
  const std::string body = WithoutScripts(RenderArchivePage(ExampleArchive()));
  const std::string header = body.substr(0, body.find("</header>"));
  for (const char* text : {"Fathom 0.1.0",
                           "2026-11-24T06:12:00Z",
                           "/data/pool_rov/2021-2026",
                           "--jobs=8 --diagnose"}) {
    EXPECT_THAT(header, HasSubstr(text));
  }
}

// Of an archive in which every text is `text`.
std::string PageWith(const std::string& text) {
  ArchiveReport report;
  report.archive = text;
  report.origin = {text, text, text, {}};
  report.dives = {text, "b" + text};
  report.tables.outliers = {{text, text, text, text}};
  report.other_files = {{text, 2}};
  report.pages[{text, text}] = text;
  Tables& tables = report.tables;
  LogRow log;
  log.path = log.dive = log.start = log.status = log.message = log.vehicle = text;
  tables.logs = {log};
  DiveFitRow fit;
  fit.dive = fit.dof = fit.parameter = fit.unit = fit.message = fit.vehicle = text;
  fit.usable = true;
  fit.value = 1.0;
  tables.dive_fits = {fit};
  tables.verdicts = {{text, text, text, text, text}};
  CauseRow cause;
  cause.log = cause.dof = cause.effect = cause.parameter = text;
  tables.causes = {cause};
  tables.findings = {{text, text, text, text, text}};
  ChangeRow change;
  change.dof = change.parameter = change.at = change.cause = change.vehicle = change.text = text;
  change.kind = "step";
  tables.changes = {change};
  return RenderArchivePage(report);
}

TEST(ArchivePage, EscapesEveryText) {
  const std::string html = PageWith("<script>'&\"</script>");
  EXPECT_THAT(html, HasSubstr("&lt;script&gt;&#39;&amp;&quot;&lt;/script&gt;"));
  EXPECT_THAT(html, Not(HasSubstr("<script>'")));
  EXPECT_THAT(html, Not(HasSubstr("\"</script>\"")));
}

TEST(ArchivePage, KeepsNamesOfEveryAlphabet) {
  for (const char* name : {"潜水 07", "погружение 3", "غوص", "plongée n° 2 🐟"}) {
    EXPECT_THAT(WithoutScripts(PageWith(name)), HasSubstr(name));
  }
}

TEST(ArchivePage, ReplacesBytesThatAreNotUtf8) {
  const std::string html = PageWith("dive \xff\xc3(");
  EXPECT_EQ(html.find('\xff'), std::string::npos);
  EXPECT_THAT(html, HasSubstr("dive \xEF\xBF\xBD"));
}

TEST(ArchivePage, ReferencesNothingOutsideItself) {
  const std::string html = RenderArchivePage(ExampleArchive());
  EXPECT_THAT(html, HasSubstr("default-src 'none'"));
  for (const char* reference : {"https:", "src=", "url(", "@import", "<link", "import("}) {
    EXPECT_EQ(html.find(reference), std::string::npos) << reference;
  }
}

TEST(ArchivePage, StandsWithoutAnyLog) {
  const std::string body = WithoutScripts(RenderArchivePage({}));
  EXPECT_THAT(body, HasSubstr("No statement on change: no dive has a usable joint fit."));
  EXPECT_THAT(body, HasSubstr("There are no logs."));
}

// 2000 dives of 5 logs, 3 DOFs and 4 parameters.
TEST(ArchivePage, OfThousandsOfDivesIsAFewMegabytes) {
  EXPECT_LT(RenderArchivePage(ExampleArchive({2000, 5})).size(), 5'000'000u);
}

}  // namespace
}  // namespace fathom
