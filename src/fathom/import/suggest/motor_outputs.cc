// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/suggest/motor_outputs.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr int kMostOutputs = 32;  // of ArduPilot

std::optional<double> Setting(const Contents& contents, const std::string& name) {
  const auto found = contents.parameters.find(name);
  if (found == contents.parameters.end()) return std::nullopt;
  return found->second;
}

// From 1 on; nothing for a function that is no motor.
std::optional<int> MotorOfFunction(double function) {
  if (function >= 33.0 && function <= 40.0) return static_cast<int>(function) - 32;
  if (function >= 82.0 && function <= 85.0) return static_cast<int>(function) - 73;
  return std::nullopt;
}

// By their settings; of two outputs that drive one motor the first, as both send the same.
std::vector<MotorOutput> MotorsBySettings(const Contents& contents, bool* has_settings) {
  std::vector<MotorOutput> motors;
  for (int output = 1; output <= kMostOutputs; ++output) {
    const auto function = Setting(contents, fmt::format("SERVO{}_FUNCTION", output));
    if (!function) continue;
    *has_settings = true;
    const auto motor = MotorOfFunction(*function);
    if (!motor) continue;
    motors.resize(std::max(motors.size(), static_cast<std::size_t>(*motor)));
    if (motors[*motor - 1].output == 0) motors[*motor - 1].output = output;
  }
  return motors;
}

// Of a vehicle without motors the throttle of a boat.
void TakeThrottle(MotorOutputs* outputs) {
  const auto& throttle = outputs->boat.throttle;
  if (!outputs->motors.empty()) {
    if (!throttle) return;
    outputs->boat.notes.push_back(fmt::format(
        "SERVO{}_FUNCTION is 70 (throttle) beside motors: not taken", throttle->output));
  } else if (throttle) {
    MotorOutput motor = {throttle->output, {}, throttle->is_reversed, 70};
    if (throttle->middle > 0.0) motor.middle = throttle->middle;
    outputs->motors.push_back(std::move(motor));
  } else if (!outputs->boat.steering && outputs->unknown.empty()) {
    outputs->unknown =
        "no output is a motor's: no SERVOn_FUNCTION is 33 to 40, or 82 to 85, or of a boat 26 or "
        "70";
  }
}

// Leaves out the motors behind the last one that is ever driven; where it is not known which
// outputs are motors, those from the first one on that is not.
void KeepDriven(const Recording& recording, bool are_known, std::vector<MotorOutput>* motors) {
  std::vector<FieldPlace> places;
  for (const MotorOutput& motor : *motors) places.push_back(motor.place);
  const std::vector<bool> reaches = ThatReach(recording, places, kShortestPulse);
  const auto end = are_known ? std::find(reaches.rbegin(), reaches.rend(), true).base()
                             : std::find(reaches.begin(), reaches.end(), false);
  motors->resize(static_cast<std::size_t>(end - reaches.begin()));
}

}  // namespace

MotorOutputs MotorOutputsOf(const Recording& recording,
                            const std::vector<std::string>& channels,
                            const std::string& field) {
  const Contents& contents = recording.contents();
  const auto place_of = [&](int output) -> std::optional<FieldPlace> {
    const std::string name = WithNumber(field, output);
    for (const std::string& channel : channels) {
      if (HasField(contents, channel, name)) return FieldPlace{channel, name};
    }
    return std::nullopt;
  };
  MotorOutputs outputs;
  bool has_settings = false;
  outputs.motors = MotorsBySettings(contents, &has_settings);
  if (!has_settings) {
    outputs.unknown =
        "which output drives which motor is not known: the log holds no setting SERVOn_FUNCTION";
    while (place_of(static_cast<int>(outputs.motors.size()) + 1)) {
      outputs.motors.push_back({static_cast<int>(outputs.motors.size()) + 1, {}, {}});
    }
  } else {
    outputs.boat = BoatOutputsOf(contents, place_of);
    outputs.unknown = outputs.boat.unknown;
    TakeThrottle(&outputs);
  }
  for (std::size_t i = 0; i < outputs.motors.size(); ++i) {
    MotorOutput& motor = outputs.motors[i];
    const std::optional<FieldPlace> place =
        motor.output == 0 ? std::nullopt : place_of(motor.output);
    if (place) {
      motor.place = *place;
    } else if (outputs.unknown.empty()) {
      outputs.unknown =
          motor.output == 0
              ? fmt::format("no output drives motor {} of {}", i + 1, outputs.motors.size())
              : fmt::format("motor {} is driven by output {}, whose pulses the log does not hold",
                            i + 1,
                            motor.output);
    }
    if (motor.function) continue;
    const auto direction = Setting(contents, fmt::format("MOT_{}_DIRECTION", i + 1));
    if (direction) motor.is_reversed = *direction < 0.0;
  }
  KeepDriven(recording, has_settings, &outputs.motors);
  if (outputs.boat.throttle && outputs.motors.empty()) {
    outputs.boat.notes.push_back(
        fmt::format("SERVO{0}_FUNCTION is 70, and output {0} never sends a pulse: no thruster",
                    outputs.boat.throttle->output));
  }
  for (std::size_t i = 0; i < outputs.motors.size() && outputs.unknown.empty(); ++i) {
    if (outputs.motors[i].is_reversed) continue;
    outputs.unknown = fmt::format(
        "which way round motor {0} turns is not known: the log holds no setting MOT_{0}_DIRECTION",
        i + 1);
  }
  return outputs;
}

std::string ThrusterLines(const MotorOutputs& outputs,
                          int num_thrusters,
                          const std::string& channel) {
  std::string text;
  for (int i = 1; i <= std::min<int>(num_thrusters, std::ssize(outputs.motors)); ++i) {
    const MotorOutput& motor = outputs.motors[i - 1];
    if (motor.place.field.empty()) {
      text += fmt::format("  # thruster_{}: ?\n", i);
      continue;
    }
    const bool is_reversed = motor.is_reversed.value_or(false);
    std::string entry = motor.place.field;
    if (is_reversed || motor.place.channel != channel) {
      // Turned round about 1500 us; the offset makes it the pulse at rest.
      const double off = is_reversed ? 2.0 * (1500.0 - motor.middle) : 0.0;
      entry = fmt::format("{{{}field: {}{}{}}}",
                          motor.place.channel == channel
                              ? ""
                              : fmt::format("channel: \"{}\", ", motor.place.channel),
                          motor.place.field,
                          off == 0.0 ? "" : fmt::format(", offset: {:g}", off),
                          is_reversed ? ", reversed: true" : "");
    }
    std::string why;
    if (motor.function) {
      why = fmt::format("SERVO{}_FUNCTION is {}", motor.output, *motor.function);
    } else if (motor.output != i) {
      why = fmt::format("SERVO{}_FUNCTION is {}", motor.output, i <= 8 ? i + 32 : i + 73);
    }
    if (is_reversed) {
      why += motor.function ? fmt::format(", SERVO{}_REVERSED is 1", motor.output)
                            : fmt::format("{}MOT_{}_DIRECTION is -1", why.empty() ? "" : ", ", i);
    }
    text += fmt::format("  thruster_{}: {}{}{}\n", i, entry, why.empty() ? "" : "  # ", why);
  }
  return text;
}

void TellUnknownOutputs(const MotorOutputs& outputs, SuggestedMap* map) {
  if (outputs.unknown.empty()) return;
  map->unknown = outputs.unknown;
  map->text = fmt::format(
                  "# Not ready: {}.\n# Set right below which output drives which thruster{}, and "
                  "which way round (reversed: true).\n",
                  outputs.unknown,
                  outputs.boat.steering ? " or fin" : "") +
              map->text;
  map->is_ready = false;
  map->needs_vehicle = false;
}

}  // namespace fathom
