// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/convert/import_log.h"

#include "fathom/base/input_error.h"
#include "fathom/base/plural.h"
#include "fathom/base/quoted.h"
#include "fathom/import/convert/fin_pulses.h"
#include "fathom/import/convert/gather_streams.h"
#include "fathom/import/convert/our_axes.h"
#include "fathom/vehicle/files/thruster_command.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

// A pulse so far below a thrust table commands nothing: the output is off, as at PX4's 900 us while
// it is disarmed [us].
constexpr double kOffBelow = 50.0;

constexpr double kLongestVoltageGap = 60.0;  // [s] that a measured voltage stands for

// A voltage that is taken from farther away than this is told.
constexpr double kCloseSteps = 3.0;
constexpr double kShortestClose = 1.0;  // [s]

// One unit for all thrusters: that of a command.
Dimension ThrusterDimension(const std::filesystem::path& file, const GatheredStream& command) {
  const Dimension first = command.dimensions.front();
  const bool is_one = std::all_of(command.dimensions.begin(),
                                  command.dimensions.end(),
                                  [&](Dimension dimension) { return dimension == first; });
  if (is_one) return first;
  throw InputError(file.string() +
                   ": command: thrusters have units of several kinds, expected one for all.");
}

// The supply voltage at each stamp of the command.
std::vector<double> VoltageAt(const std::filesystem::path& file,
                              const std::vector<double>& time,
                              const GatheredStreams& gathered,
                              const ImportMap& map,
                              const Vehicle& vehicle,
                              std::vector<std::string>* remarks) {
  if (gathered.voltage) {
    const ChannelSamples& measured = *gathered.voltage;
    std::vector<double> voltage = InterpolatedAt(measured, time, kLongestVoltageGap).front();
    // Before the first and behind the last measurement the nearest one holds, as in a gap.
    const double close = std::max(kCloseSteps * StepOf(measured), kShortestClose);
    std::size_t num_far = 0;
    double farthest = 0.0;
    for (std::size_t row = 0; row < time.size(); ++row) {
      if (std::isfinite(voltage[row])) continue;
      const auto after = std::lower_bound(measured.time.begin(), measured.time.end(), time[row]);
      const auto index = after == measured.time.begin() ? 0 : after - measured.time.begin() - 1;
      voltage[row] = measured.values.front()[index];
      const double distance = std::abs(time[row] - measured.time[index]);
      if (distance > close) ++num_far;
      farthest = std::max(farthest, distance);
    }
    if (num_far > 0) {
      remarks->push_back(
          fmt::format("command: at {} of {} no voltage is measured: the one before is held, or at "
                      "the begin the first, over up to {:.1f} s. {} has samples from {:.3f} to "
                      "{:.3f} s.",
                      Plural(num_far, "row"),
                      time.size(),
                      farthest,
                      measured.channel,
                      measured.time.front(),
                      measured.time.back()));
    }
    return voltage;
  }
  if (map.fixed_voltage) return std::vector<double>(time.size(), *map.fixed_voltage);
  const bool has_one = std::all_of(
      vehicle.thrust_tables.begin(), vehicle.thrust_tables.end(), [](const ThrustTable& table) {
        return table.voltages.size() == 1;
      });
  if (!has_one) {
    throw InputError(
        file.string() +
        ": command: the vehicle's thrust tables are for several voltages, expected the "
        "map to give the 'voltage' of the supply: a number, or the field that holds it.");
  }
  const double voltage = vehicle.thrust_tables.front().voltages.front();
  remarks->push_back(
      fmt::format("the supply is taken as {} V, for which the thrust table holds.", voltage));
  return std::vector<double>(time.size(), voltage);
}

// Makes 0, which is no thrust, of the pulses of outputs that are off. Of a reversed thruster they
// lie above its table.
void SwitchOff(const StreamMap& map,
               const Vehicle& vehicle,
               Stream* pulses,
               std::vector<std::string>* remarks) {
  for (std::size_t i = 0; i < vehicle.thrusters.size(); ++i) {
    const std::string name = fmt::format("thruster_{}", i + 1);
    const auto column = std::ranges::find(pulses->columns, name);
    const ThrustTable* table = TableOf(vehicle.thrusters[i], vehicle);
    if (column == pulses->columns.end() || table == nullptr) continue;
    const bool is_reversed = map.Find(name)->is_reversed;
    std::size_t num_off = 0;
    for (double& pulse : pulses->values[column - pulses->columns.begin()]) {
      const bool is_off = is_reversed ? pulse > table->commands.back() + kOffBelow
                                      : pulse < table->commands.front() - kOffBelow;
      if (!is_off) continue;
      ++num_off;
      pulse = 0.0;
    }
    if (num_off == 0) continue;
    remarks->push_back(
        fmt::format("command: {}: at {} of {} the output is off (no pulse, or one "
                    "over {:g} us below the thrust table), and gives no thrust.",
                    name,
                    Plural(num_off, "row"),
                    pulses->time.size(),
                    kOffBelow));
  }
}

// The thrusts [N] that were commanded; speeds in Hz stay, and Fathom turns them by the vehicle
// file.
Stream ThrusterCommand(const std::filesystem::path& file,
                       const GatheredStreams& gathered,
                       const ImportMap& map,
                       const Vehicle& vehicle,
                       Dimension dimension,
                       std::vector<std::string>* remarks) {
  const GatheredStream& command = *gathered.command;
  Stream stream = {command.samples.time, command.columns, command.samples.values};
  if (vehicle.thrusters.empty()) {
    throw InputError(
        fmt::format("{}: command: is one of {}, and the vehicle file of '{}' has no thrusters yet. "
                    "Fill them in: docs/file_formats.md.",
                    file.string(),
                    Plural(command.columns.size(), "thruster"),
                    vehicle.name));
  }
  if (dimension == Dimension::kRotation || dimension == Dimension::kForce) return stream;
  if (dimension == Dimension::kPulse) SwitchOff(*map.command, vehicle, &stream, remarks);
  std::size_t num_beyond = 0;
  Stream thrusts = ThrustsFromTables(stream,
                                     dimension == Dimension::kPulse ? "us" : "1",
                                     VoltageAt(file, stream.time, gathered, map, vehicle, remarks),
                                     vehicle,
                                     &num_beyond);
  if (num_beyond > 0) {
    remarks->push_back(
        fmt::format("command: {} of {} lie beyond a thrust table, in command or "
                    "voltage; its end is taken.",
                    Plural(num_beyond, "row"),
                    stream.time.size()));
  }
  return thrusts;
}

// The angles of fins, or the turns of shafts, taken out of the command.
std::optional<Stream> OutOf(GatheredStream* command, std::string_view prefix) {
  Stream fins = {command->samples.time, {}, {}};
  for (std::size_t k = command->columns.size(); k-- > 0;) {
    if (!command->columns[k].starts_with(prefix)) continue;
    const auto at = static_cast<std::ptrdiff_t>(k);
    fins.columns.insert(fins.columns.begin(), command->columns[k]);
    fins.values.insert(fins.values.begin(), std::move(command->samples.values[k]));
    command->columns.erase(command->columns.begin() + at);
    command->dimensions.erase(command->dimensions.begin() + at);
    command->samples.values.erase(command->samples.values.begin() + at);
  }
  if (fins.columns.empty()) return std::nullopt;
  return fins;
}

// Forces as the map gives them, or those of the thrusts, which the log then keeps.
void AddCommand(const std::filesystem::path& file,
                const GatheredStreams& gathered,
                const ImportMap& map,
                const std::optional<Vehicle>& vehicle,
                ImportedLog* imported) {
  const GatheredStream& command = *gathered.command;
  Log& log = imported->log;
  log.command = Stream{command.samples.time, command.columns, command.samples.values};
  if (!IsOfThrusters(*log.command)) {
    TurnCommand(map.command->frame.value_or(Frame::kFrd), &*log.command);
    return;
  }
  const Dimension dimension = ThrusterDimension(file, command);
  if (!vehicle) {
    throw InputError(file.string() +
                     ": command: is one of thrusters, expected the map to name the 'vehicle' file "
                     "that says where they are and how they push.");
  }
  log.command = ThrusterCommand(file, gathered, map, *vehicle, dimension, &imported->remarks);
  if (dimension == Dimension::kRotation) return;
  log.thrusters = std::move(log.command);
  log.command = ForcesOfThrusts(*log.thrusters, *vehicle);
}

// The DOFs whose force changes.
std::vector<Dof> MovedBy(const Stream& command) {
  std::vector<Dof> dofs;
  for (const Dof dof : kAllDofs) {
    const auto* column = command.Find(ForceColumn(dof));
    if (column == nullptr) continue;
    const auto [least, most] = std::minmax_element(column->begin(), column->end());
    if (*least < *most) dofs.push_back(dof);
  }
  return dofs;
}

// When the clock of the camera's video is at 0, in the time of the log.
double VideoStart(const std::filesystem::path& file,
                  const Contents& contents,
                  const ImportMap& map) {
  const CameraMap& camera = *map.camera;
  if (!camera.is_utc) return camera.start;
  const bool has_own_stamps = [&] {
    for (const auto& stream : {map.command, map.velocity, map.pose}) {
      if (stream && (stream->time || stream->rate)) return false;
    }
    return true;
  }();
  if (contents.utc_of_zero && has_own_stamps) return camera.start - *contents.utc_of_zero;
  throw InputError(
      file.string() +
      ": camera: the video's start is in UTC, and the recording's stamps are not known "
      "to be, expected a 'start' in seconds of the log's time.");
}

// When the log began, by the streams that keep the recording's own stamps [s since 1970].
std::optional<double> StartOf(const Contents& contents, const ImportMap& map, const Log& log) {
  if (!contents.utc_of_zero) return std::nullopt;
  std::optional<double> first;
  const auto take = [&](const std::optional<StreamMap>& of_map,
                        const std::optional<Stream>& stream) {
    if (!of_map || !stream || of_map->time || of_map->rate) return;
    first = std::min(first.value_or(stream->time.front()), stream->time.front());
  };
  take(map.command, log.command ? log.command : log.fins ? log.fins : log.shafts);
  take(map.velocity, log.velocity);
  take(map.pose, log.pose);
  if (!first) return std::nullopt;
  return *contents.utc_of_zero + *first;
}

}  // namespace

ImportedLog ImportLog(const std::filesystem::path& file,
                      const Recording& recording,
                      const ImportMap& map,
                      const std::optional<Vehicle>& vehicle) {
  GatheredStreams gathered = GatherStreams(file, recording, map);
  ImportedLog imported;
  imported.remarks = recording.contents().remarks;
  imported.remarks.insert(imported.remarks.end(), gathered.remarks.begin(), gathered.remarks.end());
  Log& log = imported.log;
  log.name = map.name.empty() ? ShownOnOneLine(file.stem().string()) : map.name;
  log.dive = map.dive;
  log.notes = map.notes;
  log.mass = map.mass;
  log.held_out = map.held_out;
  log.command_unit = map.command_unit;
  log.origin.emplace();
  log.origin->out_of_order = std::move(gathered.out_of_order);
  log.origin->row_counter = std::move(gathered.row_counter);
  if (gathered.command) {
    log.fins = OutOf(&*gathered.command, "fin_");
    log.shafts = OutOf(&*gathered.command, "shaft_");
  }
  if (log.fins) AnglesOfPulses(file, *map.command, vehicle, &*log.fins, &imported.remarks);
  if (gathered.command && !gathered.command->columns.empty()) {
    AddCommand(file, gathered, map, vehicle, &imported);
  }
  if (gathered.pose) {
    log.pose =
        PosesOf(file, *gathered.pose, map.pose->frame.value_or(Frame::kNed), &imported.remarks);
  }
  if (gathered.velocity) {
    log.velocity = BodyVelocitiesOf(file,
                                    *gathered.velocity,
                                    map.velocity->frame.value_or(Frame::kFrd),
                                    log.pose,
                                    &imported.remarks);
  }
  log.dofs = map.dofs;
  if (log.dofs.empty() && log.command) {
    // Speeds of thrusters move what the vehicle file says they push.
    log.dofs = MovedBy(vehicle && IsOfThrusters(*log.command)
                           ? ForcesOfThrusts(ThrustsFromSpeeds(*log.command, *vehicle), *vehicle)
                           : *log.command);
  }
  if (log.dofs.empty()) {
    throw InputError(fmt::format(
        "{}: {}, so that nothing says which DOF moves, expected the map to name {} 'dof'.",
        file.string(),
        log.command  ? "no command changes"
        : log.shafts ? "the map's command is of shafts without forces"
        : log.fins   ? "the map's command is of fins alone"
                     : "the map names no command",
        log.command || log.fins || log.shafts ? "it with" : "a 'command', or the DOF with"));
  }
  log.start = StartOf(recording.contents(), map, log);
  if (map.camera) {
    log.video = map.camera->Files().front().first;
    log.video_start = VideoStart(file, recording.contents(), map);
  }
  return imported;
}

}  // namespace fathom
