// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/identifier_flags.h"

#include "fathom/base/input_error.h"
#include "fathom/base/number.h"

#include <limits>

#include <fmt/format.h>
#include <gflags/gflags.h>

DEFINE_string(gains,
              "",
              "Gains of the adaptive law, a_m,l1,l2,l3,l4 (a_m below 0, the others above 0). "
              "Default: chosen from the data.");
DEFINE_string(integrator,
              "runge_kutta",
              "Integrator of the adaptive law: runge_kutta, or euler as in the paper.");
DEFINE_double(huber,
              3.0,
              "Output error: residuals beyond this many robust standard deviations count "
              "linearly. 0: plain least squares.");
DEFINE_double(shooting_window,
              600.0,
              "Output error: longer segments are cut into windows of this length [s], each with "
              "its own initial state. 0: never.");
DEFINE_string(
    weighting,
    "plain",
    "Output error: plain (all samples alike), or learned (by sensor noise and disturbance, "
    "learned along).");

namespace fathom {
namespace {

double ParseNumber(const std::string& flag, const std::string& text) {
  const std::optional<double> value = ParseFiniteNumber(text);
  if (!value) throw InputError(fmt::format("{}: '{}' is not a finite number.", flag, text));
  return *value;
}

// Zero stands for "never" on the command line, infinity in the options.
double NeverIfZero(const char* flag, double value) {
  if (!(value >= 0.0)) {
    throw InputError(fmt::format("{}: is {}, expected 0 (never) or a number above.", flag, value));
  }
  return value == 0.0 ? std::numeric_limits<double>::infinity() : value;
}

}  // namespace

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
  options.output_error.huber_k = NeverIfZero("--huber", FLAGS_huber);
  options.output_error.shooting_window = NeverIfZero("--shooting_window", FLAGS_shooting_window);
  options.output_error.weighting = ParseFlag("weighting", FLAGS_weighting, ParseWeighting);
  return options;
}

}  // namespace fathom
