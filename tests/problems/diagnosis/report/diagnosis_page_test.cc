// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/report/diagnosis_page.h"

#include "fathom/diagnosis/report/diagnosis_panels.h"
#include "fathom/diagnosis/report/diagnosis_tables.h"
#include "fathom/diagnosis/report/verdict_sentence.h"
#include "fathom/vehicle/effects/in_words.h"

#include <cmath>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "handmade_diagnosis.h"
#include "headless_browser.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

std::vector<Diagnosis> OnePerVerdict() {
  return {
      ConsistentDiagnosis(), ExplainedDiagnosis(), AmbiguousDiagnosis(), UnexplainedDiagnosis()};
}

std::vector<std::string> HeadingsOf(const Page& page) {
  std::vector<std::string> headings;
  for (const PageSection& section : page.sections) headings.push_back(section.heading);
  return headings;
}

std::map<std::string, std::string> FactsOf(const Page& page) {
  std::map<std::string, std::string> facts;
  for (const Fact& fact : page.facts) facts[fact.name] = fact.value;
  return facts;
}

TEST(DiagnosisPage, OpensWithTheSentenceAndTheResiduals) {
  for (const Diagnosis& diagnosis : OnePerVerdict()) {
    const Page page = DiagnosisPage(diagnosis);
    ASSERT_EQ(page.lead.size(), VerdictParagraphs(diagnosis).size());
    for (std::size_t i = 0; i < page.lead.size(); ++i) {
      EXPECT_EQ(page.lead[i], InWords(VerdictParagraphs(diagnosis)[i]));
      EXPECT_EQ(page.lead[i].find_first_of("`_"), std::string::npos) << page.lead[i];
    }
    ASSERT_FALSE(page.sections.empty());
    ASSERT_EQ(page.sections[0].time_panels.size(), 1u);
    EXPECT_TRUE(page.sections[0].time_panels[0].measured.has_value());
    EXPECT_TRUE(page.sections[0].time_panels[0].has_residuals);
    EXPECT_TRUE(page.sections[0].time_panels[0].is_low);
    EXPECT_EQ(FactsOf(page)["verdict"], Name(diagnosis.verdict));
  }
}

TEST(DiagnosisPage, SaysFirstWhatIsRed) {
  Diagnosis diagnosis = ConsistentDiagnosis();
  diagnosis.findings = {{Severity::kWarning, "passivity", "It gains energy."}};
  const Page page = DiagnosisPage(diagnosis);
  ASSERT_GE(page.lead.size(), 2u);
  EXPECT_EQ(page.lead[0],
            "One red finding has to be explained before a model of this log can be believed.");
  EXPECT_EQ(page.lead[1], VerdictParagraphs(diagnosis)[0]);
}

TEST(DiagnosisPage, GoesFromTheErrorToItsCauseToTheEvidence) {
  EXPECT_THAT(HeadingsOf(DiagnosisPage(ExplainedDiagnosis())),
              ElementsAre("Before and after",
                          "What to do next",
                          "The missing force",
                          "The parameters before and after",
                          "All candidates"));
  Diagnosis diagnosis = ConsistentDiagnosis();
  diagnosis.remarks = {"3 samples were left out."};
  EXPECT_THAT(HeadingsOf(DiagnosisPage(diagnosis)),
              ElementsAre("The model and the measurement",
                          "What to do next",
                          "The missing force",
                          "The parameters",
                          "Remarks"));
}

TEST(DiagnosisPage, GivesTheCommandThatPlansTheDecidingRun) {
  const std::string command = "fathom_plan --verdict=v.json --duration=120 --out=plan";
  const auto next_steps = [](const Page& page) { return page.sections.at(1).text; };
  EXPECT_EQ(next_steps(DiagnosisPage(ExplainedDiagnosis(), command)).back(),
            "To plan the run that decides: " + command);
  EXPECT_EQ(next_steps(DiagnosisPage(ExplainedDiagnosis())).size() + 1,
            next_steps(DiagnosisPage(ExplainedDiagnosis(), command)).size());
}

// What acts on the poses alone leaves no trace in the velocities: the page shows it where it is.
TEST(DiagnosisPage, ShowsThePosesWhereTheCauseActsOnThem) {
  Diagnosis diagnosis = ConsistentDiagnosis();
  diagnosis.verdict = Verdict::kExplained;
  AddCause("pose_scale", {0.03}, {0.001}, &diagnosis);
  diagnosis.fits_displacement = true;
  diagnosis.gain_is_in_poses = true;
  diagnosis.held_out_gain = 0.31;
  diagnosis.pose_traces = {HandmadeTrace(10.0, false)};
  const Page page = DiagnosisPage(diagnosis);
  const std::vector<std::string> headings = HeadingsOf(page);
  ASSERT_GE(headings.size(), 2u);
  EXPECT_EQ(headings[0], "The poses before and after");
  EXPECT_EQ(headings[1], "Before and after");
  const TimePanel& poses = page.sections[0].time_panels.at(0);
  EXPECT_EQ(poses.quantity, "surge displacement");
  EXPECT_EQ(poses.unit, "m");
  EXPECT_EQ(poses.time, diagnosis.pose_traces[0].time);
  EXPECT_EQ(poses.responses.at(0).values, diagnosis.pose_traces[0].before);
  EXPECT_TRUE(poses.is_low);
  EXPECT_FALSE(page.sections[1].time_panels.at(0).is_low);
  EXPECT_EQ(FactsOf(page)["error on held-out poses"], "31 % less");
}

TEST(DiagnosisPage, ShowsThePosesWhereWhatIsUnexplainedMayLieInThem) {
  Diagnosis diagnosis = ConsistentDiagnosis();
  diagnosis.verdict = Verdict::kUnexplained;
  diagnosis.fits_displacement = true;
  diagnosis.pose_traces = {HandmadeTrace(10.0, false)};
  const std::vector<std::string> headings = HeadingsOf(DiagnosisPage(diagnosis));
  ASSERT_GE(headings.size(), 2u);
  EXPECT_EQ(headings[0], "The model and the measurement");
  EXPECT_EQ(headings[1], "The model and the poses");
}

TEST(DiagnosisPage, BreaksCurvesWhereNothingWasMeasured) {
  Diagnosis diagnosis = ConsistentDiagnosis();
  diagnosis.traces = {HandmadeTrace(10.0, false)};
  diagnosis.traces[0].time = {10.0, 11.0, 12.0, 43.0, 44.0, 45.0};
  const TimePanel panel = FreeRunPanels(diagnosis).at(0);
  EXPECT_THAT(panel.time, ElementsAre(10.0, 11.0, 12.0, 12.0, 43.0, 44.0, 45.0));
  EXPECT_TRUE(std::isnan(panel.measured->values[3]));
  EXPECT_TRUE(std::isnan(panel.responses[0].values[3]));
  EXPECT_EQ(panel.measured->values[4], diagnosis.traces[0].measured[3]);
}

TEST(DiagnosisPage, StatesTheFigures) {
  Diagnosis ambiguous = AmbiguousDiagnosis();
  ambiguous.noise_nmae = 0.0712;
  auto facts = FactsOf(DiagnosisPage(ambiguous));
  EXPECT_EQ(facts["cause"], "sensor lag or thruster lag");
  EXPECT_EQ(facts["squared error beyond scatter, explained"], "70 %");
  EXPECT_EQ(facts["velocity NMAE on held-out data"], "0.117 → 0.080");
  EXPECT_EQ(facts["noise alone gives"], "about 0.071");
  facts = FactsOf(DiagnosisPage(ConsistentDiagnosis()));
  EXPECT_EQ(facts.count("cause"), 0u);
  EXPECT_EQ(facts["velocity NMAE on held-out data"], "0.117");
  Diagnosis cross_validated = ConsistentDiagnosis();
  cross_validated.by_left_out_blocks = true;
  EXPECT_EQ(FactsOf(DiagnosisPage(cross_validated))["cross-validated velocity NMAE"], "0.117");
}

TEST(DiagnosisPage, FetchesNothing) {
  for (const Diagnosis& diagnosis : OnePerVerdict()) {
    std::string html = RenderPage(DiagnosisPage(diagnosis));
    const std::string licence_comment = "/*! https://github.com/leeoniya/uPlot (v1.6.32) */";
    const std::size_t at = html.find(licence_comment);
    ASSERT_NE(at, std::string::npos);
    html.erase(at, licence_comment.size());
    for (const char* reference :
         {"http:", "https:", "src=", "url(", "@import", "<link", "import("}) {
      EXPECT_EQ(html.find(reference), std::string::npos) << reference;
    }
  }
}

// The response and the residual of the free runs, and the missing force below.
TEST(DiagnosisPage, IsDrawnByABrowser) {
  if (Chromium().empty()) GTEST_SKIP() << "chromium is not installed";
  for (const Diagnosis& diagnosis : {ConsistentDiagnosis(), AmbiguousDiagnosis()}) {
    auto findings = FindingsIn(DomOf(DiagnosisPage(diagnosis)));
    ASSERT_EQ(findings.count("failed"), 0u) << findings["failed"];
    EXPECT_EQ(findings["errors"], "0") << findings["error_texts"];
    EXPECT_EQ(findings["resources_loaded"], "0");
    EXPECT_EQ(findings["charts"], "3");
    EXPECT_EQ(findings["charts_drawn"], "3");
    EXPECT_GT(std::stoi(findings["ink_before"]), 50);
    EXPECT_EQ(findings["ink_hidden"], "0");
    EXPECT_EQ(findings["ink_after"], findings["ink_before"]);
  }
}

// The band of the missing force lies behind both curves: their colours stay those of the key.
TEST(DiagnosisPage, DrawsTheMissingForceOverItsBand) {
  if (Chromium().empty()) GTEST_SKIP() << "chromium is not installed";
  auto findings = FindingsIn(DomOf(DiagnosisPage(ExplainedDiagnosis())));
  // Measured, before and after; missing force and what the causes account for.
  std::istringstream inks(findings["inks"]);
  const std::vector<int> counts{std::istream_iterator<int>(inks), {}};
  ASSERT_EQ(counts.size(), 5u) << findings["inks"];
  EXPECT_GT(counts[3], 50);
  EXPECT_GT(counts[4], 50);
}

TEST(FreeRunPanels, ShowWhatWasMeasuredBeforeAndAfter) {
  const auto panels = FreeRunPanels(ExplainedDiagnosis());
  ASSERT_EQ(panels.size(), 1u);
  EXPECT_EQ(panels[0].quantity, "surge velocity");
  EXPECT_EQ(panels[0].unit, "m/s");
  ASSERT_EQ(panels[0].responses.size(), 2u);
  EXPECT_EQ(panels[0].responses[0].name, "before");
  EXPECT_EQ(panels[0].responses[0].note, "held-out NMAE 0.117");
  EXPECT_EQ(panels[0].responses[1].name, "after");
  EXPECT_EQ(panels[0].responses[1].note, "held-out NMAE 0.080");
  // Six samples, a gap, six held out.
  ASSERT_EQ(panels[0].time.size(), 13u);
  EXPECT_EQ(panels[0].responses[0].values[2], 0.32);
  EXPECT_EQ(panels[0].responses[1].values[2], 0.3);
  EXPECT_TRUE(std::isnan(panels[0].responses[0].values[6]));
  ASSERT_EQ(panels[0].held_out.size(), 1u);
  EXPECT_EQ(panels[0].held_out[0].from, 20.0);
  EXPECT_EQ(panels[0].held_out[0].to, 25.0);
}

// Of 1.2 m/s summed up in each log one misses 0.04, the other 0.08, and a third diverges.
TEST(FreeRunPanels, BearTheFiguresOfTheirOwnLog) {
  Diagnosis diagnosis = ConsistentDiagnosis();
  diagnosis.logs = {"small", "large", "lost"};
  diagnosis.traces.clear();
  for (const std::string& log : diagnosis.logs) {
    ResidualTrace trace = HandmadeTrace(10.0, true);
    trace.log = log;
    trace.after = trace.measured;
    trace.after[2] += log == "small" ? 0.04 : 0.08;
    if (log == "lost") trace.after.clear();
    diagnosis.traces.push_back(trace);
  }
  const std::vector<TimePanel> panels = FreeRunPanels(diagnosis);
  ASSERT_EQ(panels.size(), 3u);
  EXPECT_EQ(panels[0].responses[0].note, "held-out NMAE 0.033");
  EXPECT_EQ(panels[1].responses[0].note, "held-out NMAE 0.067");
  EXPECT_EQ(panels[2].responses[0].note, "held-out diverges");
}

TEST(CommandPanels, LieBelowTheMotion) {
  Diagnosis diagnosis = ExplainedDiagnosis();
  for (ResidualTrace& trace : diagnosis.traces) {
    trace.command = {{trace.time.front() - 1.0, trace.time.front() + 2.0}, {40.0, -40.0}};
  }
  const auto panels = CommandPanels(diagnosis, diagnosis.traces);
  ASSERT_EQ(panels.size(), 1u);
  EXPECT_EQ(panels[0].quantity, "force");
  EXPECT_EQ(panels[0].time.front(), 10.0);
  EXPECT_EQ(panels[0].time.back(), 25.0);
  ASSERT_EQ(panels[0].held_out.size(), 1u);
  EXPECT_EQ(panels[0].held_out[0].from, 20.0);
  const Page page = DiagnosisPage(diagnosis);
  ASSERT_EQ(page.sections[0].time_panels.size(), 2u);
  EXPECT_EQ(page.sections[0].time_panels[1].quantity, "force");
}

TEST(FreeRunPanels, ShowOneModelWhereNothingIsNamed) {
  const auto panels = FreeRunPanels(UnexplainedDiagnosis());
  ASSERT_EQ(panels.size(), 1u);
  ASSERT_EQ(panels[0].responses.size(), 1u);
  EXPECT_EQ(panels[0].responses[0].name, "model");
}

TEST(MissingForcePanels, HaveABandOfTwoDeviations) {
  const auto panels = MissingForcePanels(ExplainedDiagnosis());
  ASSERT_EQ(panels.size(), 1u);
  EXPECT_EQ(panels[0].unit, "N");
  ASSERT_EQ(panels[0].responses.size(), 2u);
  EXPECT_THAT(panels[0].responses[0].values, ElementsAre(1.0, -2.0, 3.0, -4.0, 5.0));
  EXPECT_THAT(panels[0].responses[0].half_width, ElementsAre(1.0, 1.0, 1.0, 1.0, 1.0));
  EXPECT_THAT(panels[0].responses[1].values, ElementsAre(1.1, -2.1, 3.1, -4.1, 5.1));
}

// The stamps of two logs start again: a chart over time cannot go back.
TEST(MissingForcePanels, StartAnewWhereTimeDoes) {
  Diagnosis diagnosis = ConsistentDiagnosis();
  diagnosis.missing_force.time = {10.0, 11.0, 5.0, 6.0, 7.0};
  const auto panels = MissingForcePanels(diagnosis);
  ASSERT_EQ(panels.size(), 2u);
  EXPECT_THAT(panels[0].time, ElementsAre(10.0, 11.0));
  EXPECT_THAT(panels[1].responses[0].values, ElementsAre(3.0, -4.0, 5.0));
}

TEST(SuspectPanels, AreThoseThatWereLogged) {
  Diagnosis diagnosis = ExplainedDiagnosis();
  diagnosis.missing_force.partner_names = {"yaw"};
  diagnosis.missing_force.partner_velocities = {{0.1, 0.2, 0.1, 0.3, 0.2}};
  diagnosis.missing_force.velocity = {0.0, 0.0, 0.0, 0.0, 0.0};  // nothing to plot over
  std::vector<std::string> names;
  for (const ScatterPanel& panel : SuspectPanels(diagnosis)) names.push_back(panel.x_name);
  EXPECT_THAT(names, ElementsAre("command", "time", "yaw velocity"));
  const ScatterPanel panel = SuspectPanels(diagnosis)[2];
  EXPECT_EQ(panel.x_unit, "rad/s");
  EXPECT_EQ(panel.y_unit, "N");
  EXPECT_EQ(panel.second_y, diagnosis.missing_force.explained);
}

// Ticks at 1.433e+09 tell nothing.
TEST(SuspectPanels, CountTimeFromTheRunWhereItIsFromAnEpoch) {
  Diagnosis diagnosis = ConsistentDiagnosis();
  for (double& time : diagnosis.missing_force.time) time += 1433350629.5;
  const ScatterPanel panel = SuspectPanels(diagnosis)[1];
  EXPECT_EQ(panel.x_name, "time + 1433350639 s");
  EXPECT_THAT(panel.x, ElementsAre(0.5, 1.5, 2.5, 3.5, 4.5));
}

TEST(ParameterPanels, ShowTheCausesNullAsNoEffect) {
  const auto panels = ParameterPanels(ExplainedDiagnosis());
  ASSERT_EQ(panels.size(), 5u);
  EXPECT_EQ(panels[0].name, "inertia");
  ASSERT_EQ(panels[0].estimates.size(), 2u);
  EXPECT_EQ(panels[0].estimates[0].value, 1086.0);
  EXPECT_EQ(panels[0].estimates[0].std, 13.0);
  EXPECT_EQ(panels[0].estimates[1].value, 852.5);
  EXPECT_EQ(panels[4].name, "thrust_dead_zone: width");
  EXPECT_EQ(panels[4].unit, "N");
  EXPECT_EQ(panels[4].reference, 0.0);
  EXPECT_EQ(panels[4].reference_name, "no effect");
}

TEST(CauseTable, HoldsEffectSizeAndGroup) {
  const Table table = CauseTable(AmbiguousDiagnosis());
  ASSERT_EQ(table.rows.size(), 1u);
  EXPECT_THAT(table.rows[0].cells,
              ElementsAre("sensor_lag",
                          "time_constant",
                          "0.496 s (0.481 to 0.511 s)",
                          "< 1e-15",
                          "277",
                          "32 %",
                          "thruster_lag"));
}

TEST(BeforeAndAfterTable, SaysHowFarEachParameterMoves) {
  const Table table = BeforeAndAfterTable(ExplainedDiagnosis());
  ASSERT_EQ(table.columns.size(), 4u);
  ASSERT_EQ(table.rows.size(), 7u);
  // 852.5 / 1086 - 1 = -21.5 %; 0.0800 / 0.1169 - 1 = -31.6 %.
  EXPECT_THAT(table.rows[0].cells,
              ElementsAre("inertia [kg]", "1086 ± 13", "852.5 ± 5.9", "-21.5 %"));
  EXPECT_THAT(table.rows[3].cells,
              ElementsAre("buoyancy [N]", "-0.88 ± 0.23", "-0.810 ± 0.010", "-"));
  EXPECT_THAT(table.rows[4].cells,
              ElementsAre("thrust_dead_zone.width [N]", "-", "8.00 ± 0.17", "-"));
  EXPECT_THAT(table.rows[6].cells,
              ElementsAre("velocity NMAE, held-out data", "0.1169", "0.0800", "-31.6 %"));
}

TEST(BeforeAndAfterTable, HasNoAfterWhereNothingIsNamed) {
  const Table table = BeforeAndAfterTable(ConsistentDiagnosis());
  ASSERT_EQ(table.columns.size(), 2u);
  ASSERT_EQ(table.rows.size(), 6u);
  EXPECT_THAT(table.rows[0].cells, ElementsAre("inertia [kg]", "1086 ± 13"));
}

TEST(CandidateTable, MarksTheKeptAndShowsOnlyWhatWasRefitted) {
  const Table table = CandidateTable(ExplainedDiagnosis());
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[0].flag, RowFlag::kKept);
  EXPECT_THAT(table.rows[0].cells,
              ElementsAre("thrust_dead_zone",
                          "117.4",
                          "< 1e-15",
                          "283.8",
                          "277.0",
                          "kept: gain 284; noise alone reaches 11.2"));
  EXPECT_EQ(table.rows[1].flag, RowFlag::kNone);
  EXPECT_THAT(
      table.rows[1].cells,
      ElementsAre(
          "thrust_fade", "0.2", "0.36", "-", "-", "dropped: score 0.2; noise alone reaches 11.2"));
  EXPECT_EQ(CandidateTable(ExplainedDiagnosis(), 1).rows.size(), 1u);
}

}  // namespace
}  // namespace fathom
