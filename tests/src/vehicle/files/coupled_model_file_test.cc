// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/vehicle/files/coupled_model_file.h"

#include "fathom/vehicle/coupled/motion_structure.h"

#include <string>
#include <vector>

#include "error_from.h"
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::HasSubstr;

FittedCoupledModel Boat() {
  FittedCoupledModel fitted;
  CoupledModel& model = fitted.model;
  model.dofs = {Dof::kSurge, Dof::kSway, Dof::kYaw};
  model.coriolis = true;
  model.inertia.diagonal() << 40.0, 60.0, 0.0, 0.0, 0.0, 5.0;
  model.inertia(1, 5) = model.inertia(5, 1) = 4.0;
  model.linear_damping.diagonal() << 5.0, 8.0, 0.0, 0.0, 0.0, 2.0;
  model.linear_damping(5, 1) = -0.4;  // held
  model.quadratic_damping.diagonal() << 20.0, 40.0, 0.0, 0.0, 0.0, 3.0;
  model.thrust_gain["port"] = 0.8;
  fitted.structure = "auto";
  fitted.force_unit = "N";
  fitted.entries = StructureOf(StandardStructure::kSymmetric, model.dofs).entries;
  fitted.entries.push_back(ThrustGainEntry("port"));
  const auto size = static_cast<Eigen::Index>(fitted.entries.size());
  fitted.covariance = Eigen::MatrixXd::Identity(size, size) * 0.04;
  fitted.horizon = 20.0;
  fitted.train[0].nmae = 0.1;
  fitted.residual_autoregression[0] = {0.7, 0.1};
  fitted.residual_autoregression[1] = std::vector<double>();  // white
  fitted.caveats = {"a caveat"};
  fitted.provenance = {{"log", "tank"}};
  fitted.log_fingerprints = {"0123456789abcdef"};
  return fitted;
}

std::string Replaced(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

std::string MessageOf(const std::string& text) {
  return ErrorFrom([&] { ParseCoupledModel("m.json", text); });
}

TEST(CoupledModelFile, ReadsBackWhatWasWritten) {
  const FittedCoupledModel written = Boat();
  const std::string text = FormatCoupledModel(written);
  EXPECT_TRUE(IsCoupledModel(text));
  const FittedCoupledModel read = ParseCoupledModel("m.json", text);
  EXPECT_EQ(read.model.dofs, written.model.dofs);
  EXPECT_EQ(read.model.inertia, written.model.inertia);
  EXPECT_EQ(read.model.linear_damping, written.model.linear_damping);
  EXPECT_EQ(read.model.quadratic_damping, written.model.quadratic_damping);
  EXPECT_EQ(read.model.thrust_gain, written.model.thrust_gain);
  EXPECT_TRUE(read.model.coriolis);
  EXPECT_EQ(read.entries, written.entries);
  EXPECT_EQ(read.covariance, written.covariance);
  EXPECT_EQ(read.horizon, 20.0);
  EXPECT_EQ(read.train[0].nmae, 0.1);
  EXPECT_EQ(read.residual_autoregression, written.residual_autoregression);
  EXPECT_EQ(read.caveats, written.caveats);
  EXPECT_EQ(read.provenance, written.provenance);
  EXPECT_EQ(read.log_fingerprints, written.log_fingerprints);
}

TEST(CoupledModelFile, RefusesWhatCannotBeAModel) {
  const std::string text = FormatCoupledModel(Boat());
  EXPECT_THAT(MessageOf(Replaced(text, "0.7,", "\"loud\",")),
              HasSubstr("m.json: 'fit.surge.residual_autoregression"));
  EXPECT_THAT(MessageOf(Replaced(text, "fathom-model-2", "fathom-model-7")), HasSubstr("'schema'"));
  EXPECT_THAT(MessageOf(Replaced(text, "\"inertia.sway.yaw\"", "\"inertia.up\"")),
              HasSubstr("inertia.up"));
  EXPECT_THAT(MessageOf(Replaced(text, "\"inertia.sway.yaw\"", "\"inertia.heave\"")),
              HasSubstr("whose DOF is none of 'dofs'"));
  EXPECT_THAT(MessageOf(Replaced(text, "\"value\": 4.0", "\"value\": 40.0")),
              HasSubstr("not positive definite"));
  EXPECT_THAT(MessageOf(Replaced(text, "\"sway\"", "\"yaw\"")), HasSubstr("order"));
}

// The held number would take the place of the identified one.
TEST(CoupledModelFile, RefusesAnEntryGivenTwice) {
  const std::string text = FormatCoupledModel(Boat());
  EXPECT_EQ(
      MessageOf(Replaced(text, "\"held\": {", "\"held\": {\"inertia.yaw.sway\": 1.0,")),
      "m.json: 'held' holds 'inertia.yaw.sway', which the file holds already, expected once.");
  const std::string twice = Replaced(text, "\"inertia.surge\"", "\"inertia.yaw.sway\"");
  EXPECT_EQ(MessageOf(Replaced(twice, "\"unit\": \"kg\"", "\"unit\": \"kg m\"")),
            "m.json: 'parameters' holds 'inertia.sway.yaw', which the file holds already, expected "
            "once.");
}

// A run would take it for no lag.
TEST(CoupledModelFile, RefusesALagBelow0) {
  const std::string text = FormatCoupledModel(Boat());
  EXPECT_EQ(MessageOf(Replaced(text, "\"held\": {", "\"held\": {\"thruster_lag\": -0.3,")),
            "m.json: 'held.thruster_lag' is -0.3 s, expected a time constant of at least 0 s.");
  FittedCoupledModel boat = Boat();
  boat.model.fin_lag["rudder"] = -0.2;
  boat.entries.back() = FinLagEntry("rudder");
  EXPECT_EQ(
      MessageOf(FormatCoupledModel(boat)),
      "m.json: 'parameters.fin_lag.rudder' is -0.2 s, expected a time constant of at least 0 s.");
}

TEST(CoupledModelFile, HoldsTheLimitedRateOfAFin) {
  FittedCoupledModel boat = Boat();
  boat.model.fin_rate_limit["rudder"] = 0.3;
  boat.entries.back() = FinRateLimitEntry("rudder");
  const std::string text = FormatCoupledModel(boat);
  EXPECT_EQ(ParseCoupledModel("m.json", text).model.fin_rate_limit, boat.model.fin_rate_limit);
  EXPECT_EQ(MessageOf(Replaced(text, "\"held\": {", "\"held\": {\"fin_lag.rudder\": 0.2,")),
            "m.json: 'parameters' and 'held' give fin rudder both a fin_lag and a fin_rate_limit, "
            "expected one of them.");
  boat.model.fin_rate_limit["rudder"] = -0.3;
  EXPECT_EQ(
      MessageOf(FormatCoupledModel(boat)),
      "m.json: 'parameters.fin_rate_limit.rudder' is -0.3, which fin_rate_limit.rudder cannot "
      "be.");
}

TEST(CoupledModelFile, HoldsTheStallOfAFin) {
  FittedCoupledModel boat = Boat();
  boat.model.fin_stall["rudder"] = 0.3;
  const std::string text = FormatCoupledModel(boat);
  EXPECT_EQ(ParseCoupledModel("m.json", text).model.fin_stall, boat.model.fin_stall);
  EXPECT_EQ(MessageOf(Replaced(text, "\"fin_stall.rudder\": 0.3", "\"fin_stall.rudder\": 1.6")),
            "m.json: 'held.fin_stall.rudder' is 1.6, which fin_stall.rudder cannot be.");
}

TEST(CoupledModelFile, KnowsOtherFiles) {
  EXPECT_FALSE(IsCoupledModel("{\"schema\": \"fathom-model-1\"}"));
  EXPECT_FALSE(IsCoupledModel("no JSON"));
}

}  // namespace
}  // namespace fathom
