// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/manoeuvre.h"

#include "fathom/base/input_error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kInertia = 200.0, kDamping = 8.0, kForce = 30.0, kAft = -1.0;

// Yaw alone at a speed of 1 m/s: for small angles Nomoto's T dr/dt + r = K angle.
CoupledModel YawOnly() {
  CoupledModel model;
  model.dofs = {Dof::kYaw};
  model.inertia(5, 5) = kInertia;
  model.linear_damping(5, 5) = kDamping;
  model.fin_force = {{"rudder", kForce}};
  return model;
}

std::vector<CommandedFin> OneRudder() {
  Fin fin;
  fin.position << kAft, 0.0, 0.0;
  return {{"rudder", ArmsOf(fin), {}}};
}

double Figure(const std::vector<ManoeuvreFigure>& figures, const std::string& name) {
  for (const ManoeuvreFigure& figure : figures) {
    if (figure.name == name) return figure.value;
  }
  return NAN;
}

TEST(ParseManoeuvre, ReadsDegrees) {
  EXPECT_NEAR(ParseManoeuvre("turning_circle:35").angle, 35.0 * std::numbers::pi / 180.0, 1e-12);
  const Manoeuvre zigzag = ParseManoeuvre("zigzag:20/10");
  EXPECT_NEAR(zigzag.heading, 10.0 * std::numbers::pi / 180.0, 1e-12);
  for (const char* wrong : {"zigzag:20", "zigzag:20/0", "turning_circle", "loop:3", ""}) {
    EXPECT_THROW(ParseManoeuvre(wrong), InputError) << wrong;
  }
}

// The overshoot of Nomoto's equation by hand, the rudder turned at once:
//   r1 = r at the heading psi, s = T log((r1 + K d) / (K d)), overshoot = T r1 - K d s
TEST(RunManoeuvre, OvershootsAsNomotosEquationDoes) {
  const Manoeuvre zigzag = ParseManoeuvre("zigzag:1/1");
  const auto track = RunManoeuvre(YawOnly(), OneRudder(), zigzag, {});
  ASSERT_TRUE(track);
  const double damping = kDamping + kForce * kAft * kAft;
  const double T = kInertia / damping, Kd = kForce * -kAft / damping * zigzag.angle;
  const auto heading = [&](double t) { return Kd * (t - T * (1.0 - std::exp(-t / T))); };
  double low = 0.0, high = 100.0;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (heading(middle) < zigzag.heading ? low : high) = middle;
  }
  const double r1 = Kd * (1.0 - std::exp(-low / T));
  const double overshoot = T * r1 - Kd * T * std::log((r1 + Kd) / Kd);
  // The rudder turns at the first tenth of a second behind.
  EXPECT_NEAR(Figure(FiguresOf(zigzag, *track), "first_overshoot") * std::numbers::pi / 180.0,
              overshoot,
              0.1 * r1 + 0.01 * overshoot);
}

// To starboard, on a circle whose radius the track itself shows.
TEST(RunManoeuvre, TurnsOnACircle) {
  CoupledModel model = YawOnly();
  model.dofs = {Dof::kSurge, Dof::kSway, Dof::kYaw};
  model.inertia.diagonal() << 100.0, 150.0, 1.0, 1.0, 1.0, kInertia;
  model.coriolis = true;
  model.quadratic_damping(0, 0) = 20.0;
  model.linear_damping(1, 1) = 150.0;
  model.linear_damping(5, 5) = 100.0;
  ManoeuvreOptions options;
  options.force[0] = 20.0;
  const Manoeuvre circle = ParseManoeuvre("turning_circle:20");
  const auto track = RunManoeuvre(model, OneRudder(), circle, options);
  ASSERT_TRUE(track);
  const std::vector<ManoeuvreFigure> figures = FiguresOf(circle, *track);
  // Points of the second half turn, opposite to each other.
  double from_heading = std::numbers::pi, far = 0.0;
  std::size_t first = 0;
  while (track->heading[first] < from_heading) ++first;
  for (std::size_t k = first; k < track->time.size(); ++k) {
    far = std::max(far, (track->state[k].position - track->state[first].position).norm());
  }
  EXPECT_NEAR(2.0 * Figure(figures, "steady_radius"), far, 0.02 * far);
  EXPECT_GT(Figure(figures, "tactical_diameter"), 0.0);
  EXPECT_GT(Figure(figures, "advance"), 0.0);
}

TEST(RunManoeuvre, NeedsARudder) {
  EXPECT_FALSE(RunManoeuvre(YawOnly(), {}, ParseManoeuvre("turning_circle:20"), {}));
}

}  // namespace
}  // namespace fathom
