// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/report/verdict_file.h"

#include "fathom/diagnosis/report/verdict_sentence.h"
#include "fathom/vehicle/effects/catalogue.h"
#include "fathom/vehicle/files/model_file.h"

#include <limits>

#include "handmade_diagnosis.h"
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace fathom {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;

json Written(const Diagnosis& diagnosis) { return json::parse(FormatVerdict(diagnosis)); }

TEST(VerdictFile, HoldsTheDocumentedFields) {
  const json file = Written(ExplainedDiagnosis());
  EXPECT_EQ(file["schema"], "fathom-verdict-1");
  EXPECT_EQ(file["log"], "tank_07");
  EXPECT_EQ(file["dof"], "surge");
  EXPECT_EQ(file["verdict"], "explained");
  EXPECT_EQ(file["sentence"], VerdictSentence(ExplainedDiagnosis()));
  EXPECT_EQ(file["baseline"]["parameters"]["inertia"],
            json({{"value", 1086.0}, {"std", 13.0}, {"unit", "kg"}}));
  EXPECT_EQ(file["baseline"]["mae"], 0.0115);
  EXPECT_EQ(file["baseline"]["nmae"], 0.1147);
  EXPECT_EQ(file["baseline"]["heldout_nmae"], 0.1169);
  EXPECT_EQ(file["extended"]["parameters"]["linear_damping"]["value"], 49.8);
  EXPECT_EQ(file["extended"]["parameters"]["linear_damping"]["unit"], "kg/s");
  EXPECT_EQ(file["extended"]["nmae"], 0.0808);
  EXPECT_EQ(file["extended"]["heldout_nmae"], 0.0800);
  EXPECT_EQ(file["explained_share"], 0.7);
  EXPECT_EQ(file["heldout_gain"],
            json({{"value", 0.3157},
                  {"low", 0.23},
                  {"high", 0.371},
                  {"is_in_poses", false},
                  {"by_left_out_blocks", false},
                  {"by_left_out_logs", false}}));
}

TEST(VerdictFile, HoldsEachCause) {
  const json file = Written(AmbiguousDiagnosis());
  EXPECT_EQ(file["verdict"], "ambiguous");
  ASSERT_EQ(file["causes"].size(), 1u);
  const json& cause = file["causes"][0];
  EXPECT_EQ(cause["effect"], "sensor_lag");
  EXPECT_EQ(cause["place"], "sensor");
  EXPECT_EQ(cause["scope"], "vehicle");
  EXPECT_EQ(cause["parameters"],
            json({{"time_constant", {{"value", 0.4963}, {"std", 0.0077}, {"unit", "s"}}}}));
  EXPECT_EQ(cause["p_value"], 1e-20);
  EXPECT_EQ(cause["delta_bic"], 277.0);
  EXPECT_EQ(cause["heldout_gain"], 0.316);
  EXPECT_EQ(cause["alternatives"], json({"thruster_lag"}));
  EXPECT_EQ(cause["experiment"], AmbiguousDiagnosis().causes[0].experiment.text);
}

TEST(VerdictFile, HoldsEveryCandidate) {
  const json candidates = Written(ExplainedDiagnosis())["candidates"];
  ASSERT_EQ(candidates.size(), 2u);
  EXPECT_EQ(candidates[0]["effect"], "thrust_dead_zone");
  EXPECT_EQ(candidates[0]["kept"], true);
  EXPECT_EQ(candidates[0]["gain"], 283.8);
  EXPECT_EQ(candidates[0]["parameters"]["width"]["value"], 7.9998);
  EXPECT_EQ(candidates[1]["effect"], "thrust_fade");
  EXPECT_EQ(candidates[1]["kept"], false);
  EXPECT_EQ(candidates[1]["score"], 0.25);
  EXPECT_TRUE(candidates[1]["gain"].is_null());  // not refitted
  EXPECT_EQ(candidates[1]["parameters"], json::object());
  EXPECT_EQ(candidates[1]["why"], "dropped: score 0.2; noise alone reaches 11.2");
}

TEST(VerdictFile, GivesTheExtendedModelBackAsAModel) {
  Diagnosis diagnosis = ExplainedDiagnosis();
  AddCause("periodic_force", {1.5, -2.5, 0.7}, {0.1, 0.2, 0.01}, &diagnosis);
  diagnosis.range = {.speed = {-0.5, 0.25}, .force = {-60.0, 40.0}};
  diagnosis.extended.covariance(0, 4) = diagnosis.extended.covariance(4, 0) = -0.25;
  const FittedModel read = ParseModel("verdict.json", FormatVerdict(diagnosis, {"abc", "def"}));
  EXPECT_EQ(read.dof, Dof::kSurge);
  EXPECT_EQ(read.force_unit, "N");
  ASSERT_TRUE(read.range);
  EXPECT_EQ(read.range->speed.low, -0.5);
  EXPECT_EQ(read.range->force.high, 40.0);
  EXPECT_EQ(read.model.inertia, 852.5);
  EXPECT_EQ(read.model.quadratic_damping, 54.0);
  EXPECT_EQ(read.model.linear_damping, 49.8);
  EXPECT_EQ(read.model.buoyancy, -0.81);
  ASSERT_EQ(read.effects.size(), 2u);
  EXPECT_EQ(read.effects[0].effect, FindEffect("thrust_dead_zone"));
  EXPECT_THAT(read.effects[0].values, ElementsAre(7.9998));
  EXPECT_EQ(read.effects[1].effect, FindEffect("periodic_force"));
  EXPECT_THAT(read.effects[1].values, ElementsAre(1.5, -2.5, 0.7));
  ASSERT_EQ(read.covariance.rows(), 8);
  EXPECT_EQ(read.covariance, diagnosis.extended.covariance);
  EXPECT_THAT(read.log_fingerprints, ElementsAre("abc", "def"));
}

// thrust_curve is relative to the log's own RMS force, a coupling to another DOF: without them the
// numbers mean nothing on another log.
TEST(VerdictFile, GivesReferenceForceAndPartnerBack) {
  Diagnosis diagnosis = ExplainedDiagnosis();
  AddCause("thrust_curve", {1.2}, {0.1}, &diagnosis);
  AddCause("velocity_coupling", {12.0}, {1.0}, &diagnosis);
  auto& effects = diagnosis.extended.model.effects;
  effects[1].setting.reference_force = 37.5;
  effects[2].setting.partner = Dof::kYaw;
  const FittedModel read = ParseModel("verdict.json", FormatVerdict(diagnosis));
  ASSERT_EQ(read.effects.size(), 3u);
  EXPECT_EQ(read.effects[1].setting.reference_force, 37.5);
  EXPECT_EQ(read.effects[2].setting.partner, Dof::kYaw);
}

TEST(VerdictFile, OfAConsistentLogIsItsBaseline) {
  const FittedModel read = ParseModel("verdict.json", FormatVerdict(ConsistentDiagnosis()));
  EXPECT_EQ(read.model.inertia, 1086.0);
  EXPECT_TRUE(read.effects.empty());
  EXPECT_EQ(Written(ConsistentDiagnosis())["causes"], json::array());
}

TEST(VerdictFile, WritesWhatWasNotComputedAsNull) {
  Diagnosis diagnosis = ConsistentDiagnosis();
  diagnosis.baseline.held_out.nmae = std::numeric_limits<double>::quiet_NaN();
  diagnosis.held_out_gain = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(Written(diagnosis)["baseline"]["heldout_nmae"].is_null());
  EXPECT_TRUE(Written(diagnosis)["heldout_gain"]["value"].is_null());
}

TEST(VerdictFile, NamesEveryLog) {
  Diagnosis diagnosis = ConsistentDiagnosis();
  diagnosis.logs = {"tank_07", "tank_08"};
  EXPECT_EQ(Written(diagnosis)["log"], "tank_07, tank_08");
  EXPECT_EQ(Written(diagnosis)["logs"], json({"tank_07", "tank_08"}));
}

// A log's name is the user's own: bytes that are not UTF-8 must not take the verdict with them.
TEST(VerdictFile, SurvivesANameThatIsNotUtf8) {
  Diagnosis diagnosis = ConsistentDiagnosis();
  diagnosis.logs = {"caf\xe9"};
  EXPECT_EQ(Written(diagnosis)["log"], "caf\xef\xbf\xbd");
}

}  // namespace
}  // namespace fathom
