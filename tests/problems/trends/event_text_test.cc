// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/trends/event_text.h"

#include <gtest/gtest.h>

namespace fathom {
namespace {

// Surge and sway, inertia and quadratic damping of each; every standard deviation is 1 scale.
struct TextCase {
  std::vector<DiveSeries> series = {{Dof::kSurge, kInertia, {}, {}, 2.0, {}, {}},
                                    {Dof::kSurge, kQuadraticDamping, {}, {}, 0.5, {}, {}},
                                    {Dof::kSway, kInertia, {}, {}, 2.0, {}, {}},
                                    {Dof::kSway, kQuadraticDamping, {}, {}, 0.5, {}, {}}};
  EventFit event{{0, 1, 2, 3},
                 Eigen::Vector4d(50.0, 80.0, 50.0, 80.0),
                 Eigen::Vector4d(7.0, 4.0, 7.0, 6.0),
                 Eigen::MatrixXd::Identity(8, 8)};
  NamedCause named{"", {"", Eigen::MatrixXd::Zero(4, 1), Eigen::VectorXd::Zero(4)}, {}};
  std::vector<char> told = {0, 1, 0, 0};
  std::vector<std::string> names = {"a", "b", "c", "d", "e"};

  std::string Text(Column column, std::vector<std::string> alternatives = {}) const {
    return EventText(named, alternatives, event, column, series, told, names);
  }
};

TEST(EventText, TellsTheMassOfAPayload) {
  TextCase test;
  test.named.cause = "payload";
  test.named.pattern.directions << 1.0, 0.0, 1.0, 0.0;
  // 14 kg in both DOFs, each give or take 2 kg.
  EXPECT_EQ(test.Text({ChangeKind::kStep, 2}),
            "From dive c on the vehicle is 14.0 kg heavier (± 1.4) in surge and sway: payload.");
  test.event.difference *= -1.0;
  EXPECT_EQ(test.Text({ChangeKind::kStep, 2}, {"battery"}),
            "From dive c on the vehicle is 14.0 kg lighter (± 1.4) in surge and sway: payload, or "
            "as well battery.");
}

TEST(EventText, TellsTheGrowthOfDampingByDive) {
  TextCase test;
  test.named.cause = "fouling";
  test.named.pattern.share << 0.0, 1.0, 0.0, 1.0;
  test.named.fit.factor = 0.2;  // a fourth more after four dives
  test.named.fit.factor_std = 0.0256;
  EXPECT_EQ(test.Text({ChangeKind::kTrend, 0}),
            "Damping grows by 6.2 % a dive (± 1.0) in surge and sway: fouling.");
}

TEST(EventText, LeavesOutNumbersOfWhichAChangeIsNotClear) {
  TextCase test;
  test.named.cause = "fouling";
  test.named.pattern.directions << 0.0, 1.0, 0.0, 1.0;
  test.event.difference(3) = -1.9;  // standard deviations
  EXPECT_EQ(test.Text({ChangeKind::kStep, 2}),
            "From dive c on the quadratic damping in surge is 2.0 kg/m larger (± 0.5): fouling.");
  test.event.difference(1) = 1.9;  // clear of none
  EXPECT_EQ(test.Text({ChangeKind::kStep, 2}),
            "From dive c on the quadratic damping in surge is 0.9 kg/m larger (± 0.5) and the "
            "quadratic damping in sway is 0.9 kg/m smaller (± 0.5): fouling.");
}

TEST(EventText, TellsHowWeakAThrusterIs) {
  TextCase test;
  test.named.cause = "thruster(port)";
  test.named.pattern.share << 0.5, 0.5, 0.0, 0.0;
  test.named.fit.factor = 0.2;
  test.named.fit.factor_std = 0.02;
  EXPECT_EQ(test.Text({ChangeKind::kStep, 1}),
            "From dive b on the thrust of thruster port is 20 % weaker (± 2) in surge: "
            "thruster(port).");
}

TEST(EventText, TellsTheGainOfAThrusterOfACoupledModel) {
  TextCase test;
  test.series[1].entry = ThrustGainEntry("port");
  test.series[1].scale = 0.01;  // 0.8 before, 0.04 more after
  test.named.cause = "thruster(port)";
  test.named.pattern.directions << 0.0, 1.0, 0.0, 0.0;
  EXPECT_EQ(test.Text({ChangeKind::kStep, 1}),
            "From dive b on the thrust of thruster port is 5.0 % stronger (± 1.2): "
            "thruster(port).");
  EXPECT_EQ(test.Text({ChangeKind::kTrend, 0}),
            "The thrust of thruster port grows by 1.2 % a dive (± 0.3): thruster(port).");
  test.named.cause = "unnamed";
  EXPECT_EQ(test.Text({ChangeKind::kStep, 1}),
            "From dive b on the thrust gain of port is 0.040 larger (± 0.010): no known cause "
            "fits.");
}

TEST(EventText, TellsTheParametersOfWhatHasNoName) {
  TextCase test;
  test.named.cause = "unnamed";
  EXPECT_EQ(test.Text({ChangeKind::kStep, 1}),
            "From dive b on the quadratic damping in surge is 2.0 kg/m larger (± 0.5): no known "
            "cause fits.");
}

}  // namespace
}  // namespace fathom
