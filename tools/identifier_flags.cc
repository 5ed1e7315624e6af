// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tools/identifier_flags.h"

#include "fathom/base/input_error.h"
#include "fathom/base/number.h"
#include "fathom/vehicle/vehicle_file.h"

#include <cstdio>
#include <limits>

#include <fmt/format.h>
#include <gflags/gflags.h>

DEFINE_string(log,
              "",
              "Log folder, or a single CSV with columns t, tau, v (then --dof is needed).");
DEFINE_string(velocity, "", "Read this CSV as the velocity stream instead of the log's.");
DEFINE_string(gains,
              "",
              "Gains of the adaptive law, a_m,l1,l2,l3,l4 (a_m below 0, the others above); chosen "
              "from the data if not given.");
DEFINE_string(integrator,
              "runge_kutta",
              "Of the adaptive law: runge_kutta, or euler as in the paper.");
DEFINE_double(huber,
              3.0,
              "Output error: residuals beyond so many robust standard deviations count linearly; "
              "0: plain least squares.");
DEFINE_double(shooting_window,
              600.0,
              "Output error: longer segments are cut into windows of this length [s], each with an "
              "initial state of its own; 0: never.");

namespace fathom {
namespace {

double ParseNumber(const std::string& flag, const std::string& text) {
  const std::optional<double> value = ParseFiniteNumber(text);
  if (!value) throw InputError(fmt::format("{}: '{}' is not a finite number.", flag, text));
  return *value;
}

// Zero stands for "never" on the command line, infinity in the options.
double NeverIfZero(double value) {
  return value == 0.0 ? std::numeric_limits<double>::infinity() : value;
}

}  // namespace

std::vector<std::string> SplitAtCommas(const std::string& text) {
  std::vector<std::string> parts;
  if (text.empty()) return parts;
  size_t begin = 0;
  while (true) {
    const size_t comma = text.find(',', begin);
    parts.push_back(text.substr(begin, comma - begin));
    if (comma == std::string::npos) return parts;
    begin = comma + 1;
  }
}

IdentificationOptions IdentificationOptionsFromFlags() {
  IdentificationOptions options;
  if (FLAGS_integrator == "euler") {
    options.adaptive.integrator = AdaptiveIntegrator::kEuler;
  } else if (FLAGS_integrator != "runge_kutta") {
    throw InputError(
        fmt::format("--integrator: is '{}', expected euler or runge_kutta.", FLAGS_integrator));
  }
  if (!FLAGS_gains.empty()) {
    const auto parts = SplitAtCommas(FLAGS_gains);
    if (parts.size() != 5) {
      throw InputError(
          fmt::format("--gains: has {} numbers, expected 5: a_m,l1,l2,l3,l4.", parts.size()));
    }
    AdaptiveGains gains;
    gains.a_m = ParseNumber("--gains", parts[0]);
    for (int i = 0; i < 4; ++i) gains.lambda[i] = ParseNumber("--gains", parts[i + 1]);
    options.adaptive.gains = gains;
  }
  options.output_error.huber_k = NeverIfZero(FLAGS_huber);
  options.output_error.shooting_window = NeverIfZero(FLAGS_shooting_window);
  return options;
}

Log ReadLogFromFlags(const std::string& path, std::optional<Dof> dof, bool may_lack_motion) {
  ReadLogOptions options;
  options.dof = dof;
  options.velocity = FLAGS_velocity;
  options.may_lack_motion = may_lack_motion;
  Log log = ReadLog(path, options);
  const bool has_thrusters = log.command && !log.command->columns.empty() &&
                             log.command->columns[0].starts_with("thruster");
  if (has_thrusters) {
    if (!log.vehicle.ends_with(".yaml")) {
      throw InputError(fmt::format(
          "{}: command.csv holds thruster speeds, but log.yaml names no vehicle file to turn them "
          "into forces. Add `vehicle: file.yaml`.",
          path));
    }
    log.command = ForcesFromThrusters(*log.command, ReadVehicleFile(log.path / log.vehicle));
  }
  for (const std::string& remark : log.remarks) std::fprintf(stderr, "%s\n", remark.c_str());
  return log;
}

}  // namespace fathom
