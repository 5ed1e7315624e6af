// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// Zigzags of vessels that nothing but a rudder of unknown force steers: Nomoto's K and T.

#include "fathom/base/random_stream.h"
#include "fathom/coupled/coupled_identification.h"
#include "fathom/manoeuvres/manoeuvre_prediction.h"
#include "fathom/simulate/coupled/manoeuvre.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "side_by_side.h"
#include "test_folder.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

constexpr double kSpeed = 1.5, kStern = -2.0, kRateNoise = 0.004;  // [m/s], [m], [rad/s]

// Of yaw alone: K from 0.2 to 1 1/s and T from 1 to 8 s.
struct Vessel {
  double K = 0.0, T = 0.0;
};

// A 20/20 zigzag of a minute, at 10 Hz, by Nomoto's equation in steps of 1 ms.
Log ZigzagOf(const Vessel& vessel, std::uint64_t seed) {
  RandomStream random(seed, "zigzag");
  Log log;
  log.path = TestFolder();
  log.dofs = {Dof::kYaw};
  log.vehicle = "boat.yaml";
  log.command = Stream{.time = {}, .columns = {"tau_surge"}, .values = {{}}};
  log.fins = Stream{.time = {}, .columns = {"fin_rudder"}, .values = {{}}};
  log.velocity = Stream{.time = {}, .columns = {"u", "r"}, .values = {{}, {}}};
  const double most = 20.0 * std::numbers::pi / 180.0;
  double r = 0.0, heading = 0.0, angle = most;
  for (int k = 0; k < 600; ++k) {
    const double t = 0.1 * k;
    // By the right-hand rule about the fin's axis, down: a positive angle turns to port.
    if (heading > most) angle = most;
    if (heading < -most) angle = -most;
    log.command->time.push_back(t);
    log.command->values[0].push_back(5.0);
    log.fins->time.push_back(t);
    log.fins->values[0].push_back(angle);
    log.velocity->time.push_back(t);
    log.velocity->values[0].push_back(kSpeed);
    log.velocity->values[1].push_back(r + kRateNoise * random.Normal());
    for (int i = 0; i < 100; ++i) {
      // The fin's force is that of its angle to the water, which turns with it.
      const double load = std::hypot(kSpeed, kStern * r) *
                          (kSpeed * std::sin(angle) - kStern * r * std::cos(angle));
      const double push = -load * std::cos(angle) / (kSpeed * kSpeed);
      const double rate = (vessel.K * push - r) / vessel.T;
      r += 1e-3 * rate;
      heading += 1e-3 * r;
    }
  }
  return log;
}

PredictedFigure PredictedOf(const ManoeuvrePrediction& report, const std::string& name) {
  return *std::ranges::find_if(
      report.figures, [&](const PredictedFigure& figure) { return figure.figure.name == name; });
}

// About a straight track, where the fin's own damping is in both.
Vessel Linear(const Vessel& vessel) {
  const double own = 1.0 - vessel.K * kStern / kSpeed;
  return {vessel.K / own, vessel.T / own};
}

TEST(NomotoOfZigzags, IsCoveredByItsIntervals) {
  std::ofstream(TestFolder() / "boat.yaml")
      << "name: boat\nfins:\n  - {name: rudder, position: [-2, 0, 0], axis: [0, 0, 1]}\n";
  constexpr int kNumLogs = 200;
  std::vector<int> holds_K(kNumLogs, 0), holds_T(kNumLogs, 0);
  SideBySide(kNumLogs, 2, [&](std::size_t i) {
    RandomStream random(i, "vessel");
    const Vessel vessel = {0.2 + 0.8 * random.Uniform(), 1.0 + 7.0 * random.Uniform()};
    const Log log = ZigzagOf(vessel, i);
    CoupledIdentificationOptions options;
    options.dofs = {Dof::kYaw};
    options.structure = StandardStructure::kDiagonal;
    const CoupledIdentification found = IdentifyCoupled({log}, options);
    if (!found.is_usable) return;
    const ManoeuvrePrediction report =
        PredictSteering(found.fitted, log, SteeringUnits::kSi, {200, 1});
    const Vessel truth = Linear(vessel);
    const PredictedFigure K = PredictedOf(report, "K"), T = PredictedOf(report, "T");
    holds_K[i] = K.low <= truth.K && truth.K <= K.high ? 1 : 0;
    holds_T[i] = T.low <= truth.T && truth.T <= T.high ? 1 : 0;
  });
  for (const auto& [name, holds] : {std::pair{"K", holds_K}, {"T", holds_T}}) {
    const double rate = std::accumulate(holds.begin(), holds.end(), 0.0) / kNumLogs;
    std::printf("%s: %.1f %% of %d intervals\n", name, 100.0 * rate, kNumLogs);
    EXPECT_GE(rate, 0.92) << name;
    EXPECT_LE(rate, 0.98) << name;
  }
}

}  // namespace
}  // namespace fathom
