// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/suggest/boat_outputs.h"

#include <cmath>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace fathom {
namespace {

constexpr int kSteeringFunction = 26, kThrottleFunction = 70;  // of SERVOn_FUNCTION
constexpr int kMostBoatOutputs = 32;

std::optional<double> BoatSetting(const Contents& contents, int output, const char* what) {
  const auto found = contents.parameters.find(fmt::format("SERVO{}_{}", output, what));
  if (found == contents.parameters.end()) return std::nullopt;
  return found->second;
}

// Reads the pulses of an output; says what is missing.
bool ReadPulses(const Contents& contents, BoatOutput* output, std::string* unknown) {
  const auto least = BoatSetting(contents, output->output, "MIN");
  const auto middle = BoatSetting(contents, output->output, "TRIM");
  const auto most = BoatSetting(contents, output->output, "MAX");
  if (!least || !middle || !most) {
    *unknown = fmt::format(
        "the pulses of output {0} are not known: the log does not hold all of SERVO{0}_MIN, "
        "SERVO{0}_TRIM and SERVO{0}_MAX",
        output->output);
    return false;
  }
  if (!(*least < *middle && *middle < *most)) {
    *unknown = fmt::format(
        "the pulses of output {0} are no range: SERVO{0}_MIN, _TRIM and _MAX are {1:g}, {2:g} and "
        "{3:g}",
        output->output,
        *least,
        *middle,
        *most);
    return false;
  }
  output->least = *least;
  output->middle = *middle;
  output->most = *most;
  return true;
}

// By how much a small angle of a fin turns the vehicle to starboard [m].
double ToStarboard(const Fin& fin) { return fin.position.cross(AcrossFin(fin))[2]; }

// The fin that turns the vehicle most about its z; null where none does.
const Fin* RudderAmong(std::span<const Fin> fins) {
  const Fin* rudder = nullptr;
  for (const Fin& fin : fins) {
    const double arm = std::abs(ToStarboard(fin));
    if (arm > 0.0 && (rudder == nullptr || arm > std::abs(ToStarboard(*rudder)))) rudder = &fin;
  }
  return rudder;
}

}  // namespace

BoatOutputs BoatOutputsOf(const Contents& contents,
                          const std::function<std::optional<FieldPlace>(int)>& place_of) {
  BoatOutputs outputs;
  for (int output = 1; output <= kMostBoatOutputs; ++output) {
    const auto function = BoatSetting(contents, output, "FUNCTION");
    if (!function || (*function != kSteeringFunction && *function != kThrottleFunction)) continue;
    const bool is_steering = *function == kSteeringFunction;
    auto& taken = is_steering ? outputs.steering : outputs.throttle;
    const std::string setting = fmt::format("SERVO{}_FUNCTION is {:g}", output, *function);
    if (taken) {
      outputs.notes.push_back(
          fmt::format("{} too: only output {} is taken", setting, taken->output));
      continue;
    }
    const auto place = place_of(output);
    if (!place) {
      outputs.unknown = fmt::format("{}, and the log does not hold its pulses", setting);
      continue;
    }
    BoatOutput found = {.output = output, .place = *place};
    found.is_reversed = BoatSetting(contents, output, "REVERSED").value_or(0.0) != 0.0;
    std::string missing;
    const bool has_pulses = ReadPulses(contents, &found, &missing);
    if (is_steering && !has_pulses) {
      outputs.unknown = missing;  // a throttle is taken by its pulses as they are
      outputs.notes.push_back(fmt::format("{}: set `pulses` right", setting));
      found.least = 1100.0;
      found.middle = 1500.0;
      found.most = 1900.0;
    }
    taken = std::move(found);
  }
  return outputs;
}

std::string SteeringLines(const BoatOutputs& outputs,
                          std::span<const Fin> fins,
                          const std::string& channel) {
  std::string text;
  for (const std::string& note : outputs.notes) text += fmt::format("  # {}\n", note);
  if (!outputs.steering) return text;
  const BoatOutput& steering = *outputs.steering;
  const Fin* rudder = RudderAmong(fins);
  const bool turns_to_port = rudder != nullptr && ToStarboard(*rudder) < 0.0;
  if (rudder == nullptr) {
    text += "  # above 0 is to starboard: a rudder at the stern then has the axis up, [0, 0, -1]\n";
  } else if (turns_to_port) {
    text += fmt::format("  # an angle of {} above 0 turns the vehicle to port\n", rudder->name);
  }
  if (rudder == nullptr || !rudder->largest_angle) {
    text +=
        "  # the log does not tell the angle at full deflection: largest_angle of the fin in the "
        "vehicle file, or here [rad]\n";
  }
  text += fmt::format(
      "  fin_{}: {{{}field: {}, pulses: [{:g}, {:g}, {:g}]{}}}  # SERVO{}_FUNCTION is {}\n",
      rudder == nullptr ? "rudder" : rudder->name,
      steering.place.channel == channel ? ""
                                        : fmt::format("channel: \"{}\", ", steering.place.channel),
      steering.place.field,
      steering.least,
      steering.middle,
      steering.most,
      steering.is_reversed != turns_to_port ? ", reversed: true" : "",
      steering.output,
      kSteeringFunction);
  return text;
}

}  // namespace fathom
