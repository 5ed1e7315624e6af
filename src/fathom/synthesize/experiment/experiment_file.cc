// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/experiment/experiment_file.h"

#include "fathom/base/files/input_file.h"
#include "fathom/base/files/yaml_file.h"
#include "fathom/base/files/yaml_numbers.h"
#include "fathom/base/quoted.h"
#include "fathom/log/csv/csv_table.h"
#include "fathom/synthesize/experiment/input_reader.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kMostSamples = 1e6;          // of one stream
constexpr double kLongest = 1e5;              // [s]
constexpr double kShortestCorrelation = 0.1;  // [s], of turbulence
constexpr double kHighestRate = 1e4;          // [Hz]
constexpr double kLowestRate = 0.1;           // [Hz]; a log's clocks ask for no less

double Resolution(const YamlMap& map, std::string_view key) {
  const double resolution = map.Number(key, 0.0);
  if (resolution == 0.0 || (resolution >= 1e-9 && resolution <= kLargest)) return resolution;
  map.Fail(
      key,
      fmt::format(
          "is {}, expected 0 (do not round) or a number from 1e-9 to {}.", resolution, kLargest));
}

double Rate(const YamlMap& map, std::string_view key, double duration) {
  const double rate = NumberWithin(map, key, kLowestRate, kHighestRate);
  if (rate * duration > kMostSamples) {
    map.Fail(key,
             fmt::format("is {} Hz, which makes {:.3g} samples, expected at most {}.",
                         rate,
                         rate * duration,
                         kMostSamples));
  }
  return rate;
}

Sampling ReadSampling(const YamlMap& map, double duration) {
  Sampling sampling;
  sampling.rate = Rate(map, "rate", duration);
  sampling.jitter = NumberWithin(map, "jitter", 0.0, 0.4 / sampling.rate, 0.0);
  if (const auto bursts = map.OptionalMap("drop_outs")) {
    sampling.drop_outs.probability = NumberWithin(*bursts, "probability", 0.0, 1.0);
    const std::vector<double> length = bursts->Numbers("length", 2);
    if (!(0.0 < length[0] && length[0] <= length[1] && length[1] <= kLongest)) {
      bursts->Fail("length",
                   fmt::format("is [{}, {}], expected [shortest, longest] in seconds, above 0.",
                               length[0],
                               length[1]));
    }
    sampling.drop_outs.shortest = length[0];
    sampling.drop_outs.longest = length[1];
  }
  return sampling;
}

// Chance of an outlier at a sample; may be 1.
double OutlierProbability(const YamlMap& outliers) {
  return NumberWithin(outliers, "probability", 0.0, 1.0);
}

// The DOFs that a velocity sensor is asked to measure; none: what the vehicle decides.
std::vector<Dof> ReadMeasuredDofs(const YamlMap& map) {
  std::vector<Dof> dofs;
  if (!map.Has("dofs")) return dofs;
  for (const std::string& name : map.Strings("dofs")) {
    const auto dof = DofFromName(name);
    if (!dof || std::find(dofs.begin(), dofs.end(), *dof) != dofs.end()) {
      map.Fail("dofs",
               fmt::format("holds {}{}, expected surge, sway, heave, roll, pitch, yaw, each once.",
                           Quoted(name),
                           dof ? " twice" : ""));
    }
    dofs.push_back(*dof);
  }
  if (dofs.empty()) map.Fail("dofs", "is empty, expected at least one DOF.");
  std::sort(dofs.begin(), dofs.end());
  return dofs;
}

// Those whose noise an experiment may name.
std::vector<Dof> DofsWithNoise(const VelocitySensor& sensor, const Experiment& experiment) {
  if (!sensor.dofs.empty()) return sensor.dofs;
  // Thrusters, fins and shafts may move any.
  if (!experiment.thrusters.empty() || !experiment.fins.empty() || !experiment.shafts.empty()) {
    return {kAllDofs.begin(), kAllDofs.end()};
  }
  std::vector<Dof> dofs;
  for (const Drive& drive : experiment.drives) dofs.push_back(drive.dof);
  return dofs;
}

VelocitySensor ReadVelocitySensor(const YamlMap& map, const Experiment& experiment) {
  VelocitySensor sensor;
  sensor.sampling = ReadSampling(map, experiment.duration);
  sensor.dofs = ReadMeasuredDofs(map);
  const std::vector<Dof> dofs = DofsWithNoise(sensor, experiment);
  if (const auto noise = map.OptionalMap("noise")) {
    for (const Dof dof : dofs) {
      sensor.noise[Index(dof)] = NumberWithin(*noise, Name(dof), 0.0, kLargest, 0.0);
    }
  }
  if (const auto outliers = map.OptionalMap("outliers")) {
    sensor.outlier_probability = OutlierProbability(*outliers);
    for (const Dof dof : dofs) {
      sensor.outlier_size[Index(dof)] = NumberWithin(*outliers, Name(dof), 0.0, kLargest, 0.0);
    }
  }
  sensor.noise_correlation = map.Number("noise_correlation", 0.0);
  if (!(0.0 <= sensor.noise_correlation && sensor.noise_correlation < 1.0)) {
    map.Fail("noise_correlation",
             fmt::format("is {}, expected at least 0 and below 1.", sensor.noise_correlation));
  }
  sensor.resolution = Resolution(map, "resolution");
  return sensor;
}

PoseSensor ReadPoseSensor(const YamlMap& map, const Experiment& experiment) {
  PoseSensor sensor;
  sensor.sampling = ReadSampling(map, experiment.duration);
  if (const auto noise = map.OptionalMap("noise")) {
    sensor.position_noise = NumberWithin(*noise, "position", 0.0, kLargest, 0.0);
    sensor.angle_noise = NumberWithin(*noise, "angle", 0.0, std::numbers::pi, 0.0);
  }
  if (const auto outliers = map.OptionalMap("outliers")) {
    sensor.outlier_probability = OutlierProbability(*outliers);
    sensor.outlier_position = NumberWithin(*outliers, "position", 0.0, kLargest, 0.0);
    sensor.outlier_angle = NumberWithin(*outliers, "angle", 0.0, std::numbers::pi, 0.0);
  }
  sensor.resolution = Resolution(map, "resolution");
  if (sensor.resolution > 1e-4) {
    map.Fail("resolution",
             fmt::format("is {}, expected at most 1e-4: a coarser quaternion is none.",
                         sensor.resolution));
  }
  sensor.is_logged = map.Boolean("logged", true);
  return sensor;
}

TurbulenceSpec ReadTurbulence(const YamlMap& map, double duration) {
  TurbulenceSpec turbulence;
  turbulence.force = NumberWithin(map, "force", 0.0, kLargest);
  // Its sequence has some steps to each correlation time.
  const double shortest = std::max(kShortestCorrelation,
                                   duration * Turbulence::kStepsPerCorrelationTime / kMostSamples);
  turbulence.correlation_time = NumberWithin(map, "correlation_time", shortest, kLongest);
  return turbulence;
}

Drive ReadDrive(const YamlMap& map, Dof dof, double command_rate, double duration) {
  Drive drive{.dof = dof, .input = {}, .pid = {}};
  drive.initial_speed = NumberWithin(map, "initial_speed", -1e3, 1e3, 0.0);
  if (const auto turbulence = map.OptionalMap("turbulence")) {
    drive.turbulence = ReadTurbulence(*turbulence, duration);
  }
  const std::string control = map.String("control");
  if (control == "open_loop") {
    drive.input = ReadInput(map.Map("input"), command_rate);
  } else if (control == "closed_loop") {
    drive.input = ReadInput(map.Map("setpoint"), command_rate);
    const YamlMap pid = map.Map("pid");
    drive.pid = PidGains{.kp = Positive(pid, "kp"),
                         .ki = NumberWithin(pid, "ki", 0.0, kLargest, 0.0),
                         .kd = NumberWithin(pid, "kd", 0.0, kLargest, 0.0),
                         .limit = Positive(pid, "limit")};
  } else {
    map.Fail("control", fmt::format("is '{}', expected open_loop or closed_loop.", control));
  }
  return drive;
}

// Inputs by the name of a thruster or a fin.
std::vector<ActuatorDrive> ReadActuators(const YamlMap& file,
                                         std::string_view key,
                                         double command_rate) {
  std::vector<ActuatorDrive> drives;
  const auto map = file.OptionalMap(key);
  if (!map) return drives;
  for (const std::string& name : map->Keys()) {
    const ActuatorDrive& drive =
        drives.emplace_back(ActuatorDrive{name, ReadInput(map->Map(name), command_rate)});
    if (std::holds_alternative<ReplayInput>(drive.input.kind)) {
      map->Map(name).Fail("kind", "is 'file', which replays forces along a DOF alone.");
    }
  }
  return drives;
}

HeldCommand ReadReplay(const std::filesystem::path& file, Dof dof) {
  const std::string column(ForceColumn(dof));
  CsvSpec spec;
  spec.required = {column};
  const CsvTable table = ReadCsvTable(file, spec);
  return {table.stream.time, *table.stream.Find(column)};
}

}  // namespace

Experiment ReadExperimentFile(const std::filesystem::path& path) {
  Experiment experiment = ParseExperiment(path.string(), ReadFile(path));
  for (Drive& drive : experiment.drives) {
    if (auto* replay = std::get_if<ReplayInput>(&drive.input.kind)) {
      replay->command = ReadReplay(path.parent_path() / replay->file, drive.dof);
    }
  }
  return experiment;
}

Experiment ParseExperiment(const std::string& name, const std::string& text) {
  const YamlMap file = ParseYaml(name, text);
  Experiment experiment;
  experiment.name = file.Name("name");
  experiment.notes = file.String("notes", "");
  experiment.start_time = NumberWithin(file, "start_time", 0.0, 1e10, 0.0);
  experiment.duration = Positive(file, "duration");
  if (experiment.duration > kLongest) {
    file.Fail("duration",
              fmt::format("is {} s, expected at most {} s.", experiment.duration, kLongest));
  }
  experiment.command_rate = Rate(file, "command_rate", experiment.duration);
  experiment.command_resolution = Resolution(file, "command_resolution");
  for (const Dof dof : kAllDofs) {
    if (const auto map = file.OptionalMap(Name(dof))) {
      experiment.drives.push_back(
          ReadDrive(*map, dof, experiment.command_rate, experiment.duration));
    }
  }
  experiment.thrusters = ReadActuators(file, "thrusters", experiment.command_rate);
  experiment.fins = ReadActuators(file, "fins", experiment.command_rate);
  experiment.shafts = ReadActuators(file, "shafts", experiment.command_rate);
  if (!experiment.thrusters.empty() && !experiment.drives.empty()) {
    file.Fail("thrusters",
              fmt::format("stands beside '{}', expected thrusters or forces: a command.csv holds "
                          "one of them.",
                          Name(experiment.drives.front().dof)));
  }
  if (experiment.drives.empty() && experiment.thrusters.empty() && experiment.fins.empty() &&
      experiment.shafts.empty()) {
    file.Fail("drives no DOF, expected at least one of surge, sway, heave, roll, pitch, yaw.");
  }
  if (const auto map = file.OptionalMap("current")) {
    experiment.current = {NumberWithin(*map, "north", -kLargest, kLargest, 0.0),
                          NumberWithin(*map, "east", -kLargest, kLargest, 0.0)};
  }
  if (const auto map = file.OptionalMap("velocity")) {
    experiment.velocity = ReadVelocitySensor(*map, experiment);
  }
  if (const auto map = file.OptionalMap("pose")) experiment.pose = ReadPoseSensor(*map, experiment);
  if (!experiment.velocity && !(experiment.pose && experiment.pose->is_logged)) {
    file.Fail("logs no motion, expected a velocity or a pose.");
  }
  if (file.Has("held_out")) {
    for (const std::vector<double>& pair : file.NumberLists("held_out", 2)) {
      if (!(pair[0] < pair[1])) {
        file.Fail("held_out",
                  fmt::format("holds [{}, {}], expected [from, to].", pair[0], pair[1]));
      }
      experiment.held_out.push_back({pair[0], pair[1]});
    }
  }
  file.Finish();
  return experiment;
}

}  // namespace fathom
