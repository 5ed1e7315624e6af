// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "boat_log.h"

#include <cmath>
#include <random>
#include <string>

#include "run_tool.h"
#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kArm = 0.3;  // [m]

}  // namespace

std::filesystem::path WriteBoatLog(const Boat& boat, const std::filesystem::path& folder) {
  std::mt19937 random(boat.seed);
  std::uniform_real_distribution<double> level(-20.0, 20.0);
  std::normal_distribution<double> noise(0.0, 0.003);
  std::string command = "t,thruster_1,thruster_2\n",
              velocity = boat.rolls ? "t,u,r,p\n" : "t,u,r\n";
  double port = 0.0, starboard = 0.0, u = 0.0, r = 0.0;
  for (int ms = 0; ms < 80000; ++ms) {
    if (ms % 3000 == 0) {
      port = level(random);
      starboard = boat.turns ? level(random) : port;
      command += fmt::format("{},{},{}\n", 1e-3 * ms, port, starboard);
    }
    if (ms % 50 == 0) {
      velocity += fmt::format("{},{},{}", 1e-3 * ms, u + noise(random), r + noise(random));
      if (boat.rolls) velocity += fmt::format(",{}", 0.1 * std::sqrt(2.0) * std::sin(2e-3 * ms));
      velocity += "\n";
    }
    const double given = boat.starboard_gain * starboard;
    const double force = port + given, moment = kArm * (port - given);
    u += 1e-3 * (force - 8.0 * u - 20.0 * u * std::abs(u)) / 40.0;
    r += 1e-3 * (moment - 3.0 * r - 4.0 * r * std::abs(r)) / 5.0;
  }
  WriteTestFile(folder / "log.yaml",
                std::string("name: boat\ndof: [surge, yaw]\nthruster_unit: N\n") +
                    (boat.names_vehicle ? "vehicle: boat.yaml\n" : ""));
  if (boat.names_vehicle) WriteBoatFile(folder / "boat.yaml");
  WriteTestFile(folder / "command.csv", command);
  WriteTestFile(folder / "velocity.csv", velocity);
  return folder;
}

void WriteBoatFile(const std::filesystem::path& file) {
  WriteTestFile(file,
                "name: boat\nmass: 30\nthrusters:\n"
                "  - {name: port, position: [0, -0.3, 0], direction: [1, 0, 0]}\n"
                "  - {name: starboard, position: [0, 0.3, 0], direction: [1, 0, 0]}\n");
}

}  // namespace fathom
