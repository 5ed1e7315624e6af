// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/store/rows_of_log.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace fathom {
namespace {

const char kComparison[] = R"({"rows": [
  {"dof": "surge", "family": "output_error", "source": "velocity", "usable": true,
   "message": "converged.", "mae": 0.01, "nmae": 0.1, "heldout_mae": null, "heldout_nmae": null,
   "parameters": {"inertia": {"value": 40, "std": 0.5, "unit": "kg"},
                  "buoyancy": {"value": 1, "std": null, "unit": "N"}}},
  {"dof": "surge", "family": "adaptive", "source": "velocity", "usable": false,
   "message": "no fit", "parameters": {}}],
 "findings": [{"dof": "surge", "severity": "red", "code": "delay", "sentence": "It lags."}]})";

const char kVerdict[] = R"({"dof": "surge", "verdict": "effects", "sentence": "It drags a tether.",
 "causes": [{"effect": "tether", "p_value": 0.001, "heldout_gain": 0.2,
             "parameters": {"drag": {"value": 3, "std": 0.1, "unit": "kg/m"}}},
            {"effect": "velocity_coupling", "partner": "sway", "p_value": 0.01}]})";

RunRecord Ran(const std::string& output) {
  RunRecord run;
  run.end = ChildEnd::kExited;
  run.exit_code = 0;
  run.output = output;
  return run;
}

LogOutcome OutcomeWith(const std::string& comparison, const std::string& verdict) {
  LogOutcome outcome;
  outcome.path = "dive/run";
  outcome.dofs.push_back({Dof::kSurge, Ran(comparison), Ran(verdict)});
  return outcome;
}

TEST(RowsOfLog, TellsWhatTheProgramsWrote) {
  const Tables tables = RowsOfLog(OutcomeWith(kComparison, kVerdict));
  ASSERT_EQ(tables.fits.size(), 2u);
  EXPECT_EQ(tables.fits[0].log, "dive/run");
  EXPECT_EQ(tables.fits[0].parameter, "inertia");
  EXPECT_EQ(tables.fits[0].value, 40.0);
  EXPECT_EQ(tables.fits[0].unit, "kg");
  EXPECT_TRUE(std::isnan(tables.fits[1].std));
  ASSERT_EQ(tables.scores.size(), 2u);
  EXPECT_EQ(tables.scores[0].nmae, 0.1);
  EXPECT_TRUE(std::isnan(tables.scores[0].heldout_nmae));
  ASSERT_EQ(tables.verdicts.size(), 1u);
  EXPECT_EQ(tables.verdicts[0].sentence, "It drags a tether.");
  EXPECT_EQ(tables.verdicts[0].json, kVerdict);
  ASSERT_EQ(tables.causes.size(), 2u);
  EXPECT_EQ(tables.causes[0].parameter, "drag");
  EXPECT_EQ(tables.causes[1].effect, "velocity_coupling(sway)");
  ASSERT_EQ(tables.findings.size(), 1u);
  EXPECT_EQ(tables.findings[0].id, "delay");
}

const char kCoupledVerdict[] = R"({"verdict": "explained", "sentence": "Port is weak.",
 "causes": [{"entry": "thrust_gain.port", "value": 0.8, "std": 0.01, "unit": "1"}],
 "ladder": [{"structure": "diagonal", "accepted": false},
            {"structure": "thruster", "accepted": true}],
 "model": {"parameters": {"inertia.surge": {"value": 40, "std": 0.5, "unit": "kg"},
                          "thrust_gain.port": {"value": 0.8, "std": 0.01, "unit": "1"}}}})";

LogOutcome CoupledOutcome(const RunRecord& run) {
  LogOutcome outcome;
  outcome.path = "dive/run";
  outcome.coupled = {.dofs = "surge,yaw", .diagnose = run, .left_out = {}};
  return outcome;
}

TEST(RowsOfLog, TellsWhatTheCoupledModelIs) {
  const Tables tables = RowsOfLog(CoupledOutcome(Ran(kCoupledVerdict)));
  ASSERT_EQ(tables.fits.size(), 2u);
  for (const FitRow& fit : tables.fits) {
    EXPECT_EQ(fit.log, "dive/run");
    EXPECT_EQ(fit.dof, "surge,yaw");
    EXPECT_EQ(fit.family, "coupled");
    EXPECT_EQ(fit.source, "thruster");
    EXPECT_TRUE(fit.usable);
  }
  EXPECT_EQ(tables.fits[0].parameter, "inertia.surge");
  EXPECT_EQ(tables.fits[0].value, 40.0);
  EXPECT_EQ(tables.fits[0].std, 0.5);
  EXPECT_EQ(tables.fits[0].unit, "kg");
  ASSERT_EQ(tables.verdicts.size(), 1u);
  EXPECT_EQ(tables.verdicts[0].dof, "surge,yaw");
  EXPECT_EQ(tables.verdicts[0].verdict, "explained");
  EXPECT_EQ(tables.verdicts[0].json, kCoupledVerdict);
  ASSERT_EQ(tables.causes.size(), 1u);
  EXPECT_EQ(tables.causes[0].effect, "thrust_gain.port");
  EXPECT_EQ(tables.causes[0].value, 0.8);
  EXPECT_EQ(tables.causes[0].std, 0.01);
  EXPECT_TRUE(std::isnan(tables.causes[0].p_value));
}

TEST(RowsOfLog, SaysWhyThereIsNoCoupledModel) {
  RunRecord run = Ran("");
  run.exit_code = 2;
  run.message = "no diagnosis: yaw is not driven.";
  for (const auto& [record, why] :
       {std::pair{run, "no diagnosis: yaw is not driven."},
        std::pair{Ran("{\"verdict\": "), "its verdict file is damaged."}}) {
    const Tables tables = RowsOfLog(CoupledOutcome(record));
    ASSERT_EQ(tables.fits.size(), 1u);
    EXPECT_FALSE(tables.fits[0].usable);
    EXPECT_EQ(tables.fits[0].parameter, "");
    EXPECT_EQ(tables.fits[0].message, why);
    EXPECT_TRUE(tables.verdicts.empty());
    EXPECT_TRUE(tables.causes.empty());
  }
}

void ExpectNoRows(const Tables& tables) {
  EXPECT_TRUE(tables.fits.empty());
  EXPECT_TRUE(tables.scores.empty());
  EXPECT_TRUE(tables.verdicts.empty());
  EXPECT_TRUE(tables.causes.empty());
  EXPECT_TRUE(tables.findings.empty());
}

TEST(RowsOfLog, TakesNothingOutOfADamagedFile) {
  for (const std::string text : {"", "{", "null", "3", "[1, 2]", "\"rows\"", "{}", "\xff\xfe"}) {
    SCOPED_TRACE(text);
    ExpectNoRows(RowsOfLog(OutcomeWith(text, text)));
  }
}

// A file that was cut off anywhere is none.
TEST(RowsOfLog, TakesNothingOutOfAFileThatWasCutOff) {
  const std::string comparison = kComparison, verdict = kVerdict;
  for (std::size_t n = 0; n < comparison.size(); ++n) {
    ExpectNoRows(RowsOfLog(OutcomeWith(comparison.substr(0, n), verdict.substr(0, n / 2))));
  }
}

// Parts of another type than they should be.
TEST(RowsOfLog, PassesOverWhatItDoesNotKnow) {
  for (const char* part :
       {"3", "null", "\"x\"", "[1, \"x\", null, []]", "{\"a\": 1, \"b\": []}", "true"}) {
    SCOPED_TRACE(part);
    for (const char* key : {"rows", "findings", "causes", "dof", "verdict", "ladder", "model"}) {
      const std::string json = std::string("{\"") + key + "\": " + part + "}";
      EXPECT_NO_THROW(RowsOfLog(OutcomeWith(json, json)));
      EXPECT_NO_THROW(RowsOfLog(CoupledOutcome(Ran(json))));
    }
    const std::string rows = std::string("{\"rows\": [{\"parameters\": ") + part +
                             "}], \"causes\": [{\"parameters\": " + part + "}]}";
    EXPECT_NO_THROW(RowsOfLog(OutcomeWith(rows, rows)));
  }
}

TEST(RowsOfDive, SayWhyThereIsNoFit) {
  DiveTask task;
  task.dive = "dive 1";
  const auto none = RowsOfDive(task, {}, {{"dive 1/run", "it crashed"}});
  ASSERT_EQ(none.size(), 1u);
  EXPECT_FALSE(none[0].usable);
  EXPECT_EQ(none[0].parameter, "");
  EXPECT_EQ(none[0].message, "no log can be fitted. Left out: dive 1/run (it crashed).");
}

}  // namespace
}  // namespace fathom
