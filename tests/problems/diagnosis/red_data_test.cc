// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Data of which a red finding speaks are never `consistent`.

#include "fathom/diagnosis/diagnosis.h"
#include "fathom/diagnosis/report/verdict_sentence.h"
#include "fathom/vehicle/effects/catalogue.h"

#include <span>
#include <vector>

#include "surge_run.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

Diagnosis DiagnosedAlone(const Log& log) {
  DiagnosisOptions options;
  options.effects = {FindEffect("thruster_lag")};
  return Diagnose(std::span(&log, 1), Dof::kSurge, options);
}

// A sensor that writes zeros for 16 % of the time.
TEST(RedData, AreNotConsistent) {
  SurgeRun run;
  run.input = Multisine(120.0);
  Log log = LogOf(run, 1);
  ASSERT_EQ(DiagnosedAlone(log).verdict, Verdict::kConsistent);
  Stream& velocity = *log.velocity;
  for (std::size_t i = 0; i < velocity.time.size(); ++i) {
    const bool is_lost = i % 100 < 16;
    if (is_lost) velocity.values[0][i] = 0.0;
  }
  std::vector<Finding> told;  // before the search
  DiagnosisOptions options;
  options.effects = {FindEffect("thruster_lag")};
  options.on_findings = [&](const std::vector<Finding>& findings) { told = findings; };
  const Diagnosis diagnosis = Diagnose(std::span(&log, 1), Dof::kSurge, options);
  ASSERT_TRUE(diagnosis.IsUsable());
  ASSERT_FALSE(told.empty());
  EXPECT_EQ(told.front().sentence, diagnosis.findings.front().sentence);
  EXPECT_EQ(diagnosis.findings.front().severity, Severity::kWarning);
  EXPECT_NE(diagnosis.verdict, Verdict::kConsistent) << VerdictSentence(diagnosis);
}

}  // namespace
}  // namespace fathom
