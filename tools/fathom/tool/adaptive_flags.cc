// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/tool/adaptive_flags.h"

#include "fathom/base/input_error.h"
#include "fathom/base/number.h"
#include "fathom/tool/flag_values.h"

#include <fmt/format.h>
#include <gflags/gflags.h>

DEFINE_string(gains,
              "",
              "Gains of the adaptive law, a_m,l1,l2,l3,l4 (a_m below 0, the others above 0). "
              "Default: chosen from the data of a log; a stream needs them.");
DEFINE_string(integrator,
              "runge_kutta",
              "Integrator of the adaptive law: runge_kutta, or euler as in the paper.");

namespace fathom {
namespace {

double ParseGain(const std::string& text) {
  const std::optional<double> value = ParseFiniteNumber(text);
  if (!value) throw InputError(fmt::format("--gains: '{}' is not a finite number.", text));
  return *value;
}

}  // namespace

AdaptiveOptions AdaptiveOptionsFromFlags() {
  AdaptiveOptions options;
  options.integrator = ParseFlag("integrator", FLAGS_integrator, ParseAdaptiveIntegrator);
  if (FLAGS_gains.empty()) return options;
  const auto parts = SplitAtCommas(FLAGS_gains);
  if (parts.size() != 5) {
    throw InputError(
        fmt::format("--gains: has {} numbers, expected 5: a_m,l1,l2,l3,l4.", parts.size()));
  }
  AdaptiveGains gains;
  gains.a_m = ParseGain(parts[0]);
  for (int i = 0; i < 4; ++i) gains.lambda[i] = ParseGain(parts[i + 1]);
  options.gains = gains;
  return options;
}

}  // namespace fathom
