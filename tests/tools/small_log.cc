// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "small_log.h"

#include <cmath>
#include <vector>

#include "run_tool.h"
#include <fmt/format.h>

namespace fathom {
namespace {

constexpr int kNumRows = 601;

double StampOf(int row) { return 0.1 * row; }

// Turns over every 4 s, twice at 20 N and twice at 8 N.
double ForceAt(int row) {
  const int turn = row / 40;
  return (turn % 2 == 0 ? 1.0 : -1.0) * (turn % 4 < 2 ? 20.0 : 8.0);
}

// Explicit Euler of 1 ms, the force held for each row's 0.1 s.
std::vector<double> Speeds() {
  std::vector<double> speeds;
  double v = 0.0;
  for (int row = 0; row < kNumRows; ++row) {
    speeds.push_back(v);
    for (int k = 0; k < 100; ++k) {
      v += 0.001 * (ForceAt(row) - 30.0 * v * std::abs(v) - 5.0 * v - 1.0) / 40.0;
    }
  }
  return speeds;
}

}  // namespace

std::string SmallCommandCsv() {
  std::string csv = "t,tau_surge\n";
  for (int row = 0; row < kNumRows; ++row) {
    csv += fmt::format("{:.1f},{:.1f}\n", StampOf(row), ForceAt(row));
  }
  return csv;
}

std::string SmallVelocityCsv() {
  std::string csv = "t,u\n";
  const std::vector<double> speeds = Speeds();
  for (int row = 0; row < kNumRows; ++row) {
    csv += fmt::format("{:.1f},{:.9f}\n", StampOf(row), speeds[row]);
  }
  return csv;
}

std::string SmallSingleCsv() {
  std::string csv = "t,tau,v\n";
  const std::vector<double> speeds = Speeds();
  for (int row = 0; row < kNumRows; ++row) {
    csv += fmt::format("{:.1f},{:.1f},{:.9f}\n", StampOf(row), ForceAt(row), speeds[row]);
  }
  return csv;
}

std::filesystem::path WriteSmallLog(const std::filesystem::path& folder) {
  WriteTestFile(folder / "log.yaml", "name: small\ndof: surge\n");
  WriteTestFile(folder / "command.csv", SmallCommandCsv());
  WriteTestFile(folder / "velocity.csv", SmallVelocityCsv());
  return folder;
}

std::filesystem::path WriteStillLog(const std::filesystem::path& folder) {
  WriteSmallLog(folder);
  std::string command = "t,tau_surge\n", velocity = "t,u\n";
  for (int row = 0; row < 300; ++row) {
    command += fmt::format("{:.1f},0\n", StampOf(row));
    velocity += fmt::format("{:.1f},0\n", StampOf(row));
  }
  WriteTestFile(folder / "command.csv", command);
  WriteTestFile(folder / "velocity.csv", velocity);
  return folder;
}

std::string SmallModelJson() {
  return R"({"schema": "fathom-model-1", "dof": "surge",
 "structure": {"baseline": "uncoupled", "effects": []}, "force_unit": "N",
 "parameters": {"inertia": {"value": 40, "std": 0.4, "unit": "kg"},
                "quadratic_damping": {"value": 30, "std": 0.3, "unit": "kg/m"},
                "linear_damping": {"value": 5, "std": 0.2, "unit": "kg/s"},
                "buoyancy": {"value": 1, "std": 0.1, "unit": "N"}},
 "covariance": [[0.16, 0, 0, 0], [0, 0.09, 0, 0], [0, 0, 0.04, 0], [0, 0, 0, 0.01]],
 "fit": {"mae": 0.001, "nmae": 0.01, "n": 601, "duration": 60.0},
 "held_out": {"mae": null, "nmae": null, "n": 0, "duration": 0.0},
 "caveats": [], "provenance": {"log": "small"}}
)";
}

std::string SmallVehicleYaml() {
  return "name: small\n"
         "mass: 30\n"
         "size: [0.7, 0.5, 0.3]\n"
         "models:\n"
         "  surge: {inertia: 40, quadratic_damping: 30, linear_damping: 5, buoyancy: 1}\n";
}

}  // namespace fathom
