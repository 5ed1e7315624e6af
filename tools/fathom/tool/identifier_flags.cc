// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/identifier_flags.h"

#include "fathom/base/input_error.h"

#include <limits>

#include <fmt/format.h>
#include <gflags/gflags.h>

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
  options.adaptive = AdaptiveOptionsFromFlags();
  options.output_error.huber_k = NeverIfZero("--huber", FLAGS_huber);
  options.output_error.shooting_window = NeverIfZero("--shooting_window", FLAGS_shooting_window);
  options.output_error.weighting = ParseFlag("weighting", FLAGS_weighting, ParseWeighting);
  return options;
}

}  // namespace fathom
