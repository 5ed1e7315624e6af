// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "module/family_options.h"

#include <algorithm>

#include "module/arguments.h"
#include <fmt/format.h>

namespace fathom {

namespace {

AdaptiveGains GainsOf(const std::vector<double>& numbers) {
  if (numbers.size() != 5) {
    throw InputError(
        fmt::format("gains: has {} numbers, expected 5: a_m, l1, l2, l3, l4.", numbers.size()));
  }
  AdaptiveGains gains;
  gains.a_m = numbers.front();
  std::copy(numbers.begin() + 1, numbers.end(), gains.lambda.begin());
  if (const auto problems = gains.Problems(); !problems.empty()) {
    throw InputError("gains: " + problems.front());
  }
  return gains;
}

}  // namespace

IdentificationOptions OptionsOf(const FamilyArguments& arguments) {
  IdentificationOptions options;
  options.adaptive.integrator =
      ParseArgument("integrator", arguments.integrator, ParseAdaptiveIntegrator);
  if (arguments.gains) options.adaptive.gains = GainsOf(*arguments.gains);
  options.output_error.huber_k = InfiniteIfZero("huber", arguments.huber);
  options.output_error.shooting_window =
      InfiniteIfZero("shooting_window", arguments.shooting_window);
  options.output_error.weighting = ParseArgument("weighting", arguments.weighting, ParseWeighting);
  return options;
}

}  // namespace fathom
