// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "sound_log.h"

#include <cmath>

#include "run_tool.h"
#include "saved_files.h"
#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kMass = 22.5;
constexpr double kThrust = 0.04;  // of each of the two thrusters [N s^2]

std::string VehicleYaml() {
  return fmt::format(
      "name: rov\nmass: {0}\nsize: [0.6, 0.4, 0.3]\nthrusters:\n"
      "  - {{name: port, position: [-0.2, -0.15, 0], direction: [1, 0, 0], "
      "coefficient: {{forward: {1}, reverse: {1}}}}}\n"
      "  - {{name: starboard, position: [-0.2, 0.15, 0], direction: [1, 0, 0], "
      "coefficient: {{forward: {1}, reverse: {1}}}}}\n"
      "models:\n"
      "  surge: {{inertia: 38, quadratic_damping: 40, linear_damping: 8, buoyancy: 0.3}}\n",
      kMass,
      kThrust);
}

LogNumbers Synthesized(const std::filesystem::path& scratch, double rms, double noise) {
  const auto vehicle = WriteTestFile(scratch / "rov.yaml", VehicleYaml());
  const auto experiment =
      WriteTestFile(scratch / "lively.yaml",
                    fmt::format("name: lively\nduration: 150\ncommand_rate: 10\n"
                                "surge: {{control: open_loop, input: {{kind: multisine, rms: {}, "
                                "frequency: [0.1, 1.6], lines: 12}}}}\n"
                                "velocity: {{rate: 10, noise: {{surge: {}}}, resolution: 1e-5}}\n",
                                rms,
                                noise));
  const std::filesystem::path folder = scratch / "synthesized";
  RunsWell(
      "fathom_synthesize",
      {Flag("vehicle", vehicle), Flag("experiment", experiment), "--seed=1", Flag("out", folder)});
  const CsvColumns command = ReadColumns(folder / "command.csv");
  const CsvColumns velocity = ReadColumns(folder / "velocity.csv");
  LogNumbers log;
  log.command_time = command.Values("t");
  log.force = command.Values("tau_surge");
  log.time = velocity.Values("t");
  log.speed = velocity.Values("u");
  log.mass = kMass;
  return log;
}

// Thrusters that share the force: T = C Omega |Omega| each.
double ThrusterSpeedOf(double force) {
  return std::copysign(std::sqrt(std::abs(force) / 2.0 / kThrust), force);
}

}  // namespace

LogNumbers SoundLog(const std::filesystem::path& scratch) {
  return Synthesized(scratch, 15.0, 0.01);
}

LogNumbers SlowSoundLog(const std::filesystem::path& scratch) {
  return Synthesized(scratch, 0.75, 0.001);
}

std::filesystem::path Write(const LogNumbers& log, const std::filesystem::path& folder) {
  const bool has_thrusters = log.thruster_speed_unit != 0.0;
  std::string yaml = fmt::format("name: dive\ndof: surge\nmass: {}\n", log.mass);
  std::string command = has_thrusters ? "t,thruster_1,thruster_2\n" : "t,tau_surge\n";
  for (std::size_t i = 0; i < log.command_time.size(); ++i) {
    if (has_thrusters) {
      const double speed = log.thruster_speed_unit * ThrusterSpeedOf(log.force[i]);
      command += fmt::format("{},{:.5f},{:.5f}\n", log.command_time[i], speed, speed);
    } else {
      command += fmt::format("{},{:.7g}\n", log.command_time[i], log.force[i]);
    }
  }
  if (has_thrusters) {
    WriteTestFile(folder / "rov.yaml", VehicleYaml());
    yaml += "vehicle: rov.yaml\n";
  }
  std::string velocity = "t,u\n";
  for (std::size_t i = 0; i < log.time.size(); ++i) {
    velocity += fmt::format("{},{:.7g}\n", log.time[i], log.speed[i]);
  }
  WriteTestFile(folder / "log.yaml", yaml);
  WriteTestFile(folder / "command.csv", command);
  WriteTestFile(folder / "velocity.csv", velocity);
  return folder;
}

}  // namespace fathom
