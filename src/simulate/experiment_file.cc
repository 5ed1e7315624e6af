// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/experiment_file.h"

#include "fathom/base/input_file.h"
#include "fathom/base/yaml_file.h"
#include "fathom/log/csv_table.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kMostSamples = 1e6;  // of one stream
constexpr double kLongest = 1e5;      // [s]
constexpr double kLargest = 1e9;      // of any amplitude: no force or position is larger
constexpr double kHighestRate = 1e4;  // [Hz]
constexpr double kLowestRate = 0.1;   // [Hz]; a log's clocks ask for no less

double Within(const YamlMap& map, std::string_view key, double number, double from, double to) {
  if (from <= number && number <= to) return number;
  map.Fail(key, fmt::format("is {}, expected a number from {} to {}.", number, from, to));
}

double NumberWithin(const YamlMap& map, std::string_view key, double from, double to) {
  return Within(map, key, map.Number(key), from, to);
}

double NumberWithin(
    const YamlMap& map, std::string_view key, double from, double to, double if_missing) {
  return Within(map, key, map.Number(key, if_missing), from, to);
}

// A number above 0.
double Positive(const YamlMap& map, std::string_view key) {
  const double number = map.Number(key);
  if (number > 0.0 && number <= kLargest) return number;
  map.Fail(key, fmt::format("is {}, expected a number above 0 and at most {}.", number, kLargest));
}

double Amplitude(const YamlMap& map, std::string_view key) {
  return NumberWithin(map, key, -kLargest, kLargest);
}

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

VelocitySensor ReadVelocitySensor(const YamlMap& map, const Experiment& experiment) {
  VelocitySensor sensor;
  sensor.sampling = ReadSampling(map, experiment.duration);
  if (const auto noise = map.OptionalMap("noise")) {
    for (const Drive& drive : experiment.drives) {
      sensor.noise[Index(drive.dof)] = NumberWithin(*noise, Name(drive.dof), 0.0, kLargest, 0.0);
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
  sensor.resolution = Resolution(map, "resolution");
  if (sensor.resolution > 1e-4) {
    map.Fail("resolution",
             fmt::format("is {}, expected at most 1e-4: a coarser quaternion is none.",
                         sensor.resolution));
  }
  sensor.is_logged = map.Boolean("logged", true);
  return sensor;
}

// Reads one input; frequencies and holding times are such that the command stream can carry them.
class InputReader {
 public:
  InputReader(const YamlMap& map, double command_rate) : map_(map), rate_(command_rate) {}

  InputSignal Read() const {
    InputSignal input;
    input.offset = NumberWithin(map_, "offset", -kLargest, kLargest, 0.0);
    const std::string kind = map_.String("kind");
    if (kind == "sine") {
      input.kind = SineInput{.amplitude = Amplitude(map_, "amplitude"),
                             .frequency = Frequency(map_.Number("frequency")),
                             .phase = NumberWithin(map_, "phase", -kLargest, kLargest, 0.0)};
    } else if (kind == "multisine") {
      input.kind = Multisine();
    } else if (kind == "chirp") {
      const std::vector<double> range = map_.Numbers("frequency", 2);
      input.kind = ChirpInput{.amplitude = Amplitude(map_, "amplitude"),
                              .first_frequency = Frequency(range[0]),
                              .last_frequency = Frequency(range[1]),
                              .sweep = Hold("sweep")};
    } else if (kind == "steps") {
      input.kind = Steps();
    } else if (kind == "prbs") {
      input.kind = PrbsInput{.amplitude = Amplitude(map_, "amplitude"), .hold = Hold("hold")};
    } else if (kind == "square") {
      input.kind = SquareInput{.amplitude = Amplitude(map_, "amplitude"),
                               .frequency = Frequency(map_.Number("frequency"))};
    } else if (kind == "file") {
      input.kind = ReplayInput{.file = map_.String("file"), .command = {}};
    } else {
      map_.Fail(
          "kind",
          fmt::format("is '{}', expected sine, multisine, chirp, steps, prbs, square or file.",
                      kind));
    }
    return input;
  }

 private:
  MultisineInput Multisine() const {
    const std::vector<double> range = map_.Numbers("frequency", 2);
    MultisineInput sines;
    sines.rms = Amplitude(map_, "rms");
    sines.lowest_frequency = Frequency(range[0]);
    sines.highest_frequency = Frequency(range[1]);
    if (range[0] > range[1]) {
      map_.Fail("frequency",
                fmt::format("is [{}, {}], expected lowest, highest.", range[0], range[1]));
    }
    const auto num_lines = map_.Integer("lines");
    if (num_lines < 1 || num_lines > 1000) {
      map_.Fail("lines", fmt::format("is {}, expected a whole number from 1 to 1000.", num_lines));
    }
    sines.num_lines = static_cast<int>(num_lines);
    return sines;
  }

  StepsInput Steps() const {
    StepsInput steps{.levels = map_.Numbers("levels"), .hold = Hold("hold")};
    if (steps.levels.empty()) map_.Fail("levels", "is empty, expected at least one level.");
    for (const double level : steps.levels) Within(map_, "levels", level, -kLargest, kLargest);
    return steps;
  }

  double Frequency(double frequency) const {
    const double highest = std::numbers::pi * rate_;
    if (frequency > 0.0 && frequency < highest) return frequency;
    map_.Fail("frequency",
              fmt::format("holds {} rad/s, expected above 0 and below {:.4g} rad/s, half of the "
                          "command_rate.",
                          frequency,
                          highest));
  }

  double Hold(std::string_view key) const {
    const double hold = map_.Number(key);
    if (hold * rate_ >= 1.0 - 1e-9 && hold <= kLargest) return hold;
    map_.Fail(key,
              fmt::format("is {} s, expected at least one period of the command_rate, {:.4g} s.",
                          hold,
                          1.0 / rate_));
  }

  const YamlMap& map_;
  double rate_;
};

Drive ReadDrive(const YamlMap& map, Dof dof, double command_rate) {
  Drive drive{.dof = dof, .input = {}, .pid = {}};
  drive.initial_speed = NumberWithin(map, "initial_speed", -1e3, 1e3, 0.0);
  const std::string control = map.String("control");
  if (control == "open_loop") {
    drive.input = InputReader(map.Map("input"), command_rate).Read();
  } else if (control == "closed_loop") {
    drive.input = InputReader(map.Map("setpoint"), command_rate).Read();
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
  experiment.name = file.String("name");
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
      experiment.drives.push_back(ReadDrive(*map, dof, experiment.command_rate));
    }
  }
  if (experiment.drives.empty()) {
    file.Fail("drives no DOF, expected at least one of surge, sway, heave, roll, pitch, yaw.");
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
