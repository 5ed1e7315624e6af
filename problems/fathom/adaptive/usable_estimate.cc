// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/adaptive/usable_estimate.h"

#include "fathom/base/interval95.h"
#include "fathom/base/short_number.h"

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kLastPart = 1.0 / 3.0;  // of the pass, over which the scatter is taken
constexpr double kHeaviest = 0.99e5;     // [kg]: alpha has not left its lower bound
constexpr double kMostScatter = 0.5;     // of the inertia's sd, by its value

}  // namespace

std::size_t BeginOfLastPart(std::size_t num_samples) {
  return static_cast<std::size_t>((1.0 - kLastPart) * static_cast<double>(num_samples));
}

std::string WhyUnusable(const UncoupledModel<double>& model, double inertia_std) {
  if (model.inertia > kHeaviest) {
    return "The inverse of the inertia stayed at its lower bound: the force does not explain the "
           "motion. Check its sign, its unit and the clocks.";
  }
  if (!(inertia_std < kMostScatter * model.inertia)) {
    return fmt::format("The inertia did not converge: {:.4g} ± {} over the last third of the pass.",
                       model.inertia,
                       ShortNumber(kStdsOf95 * inertia_std, 2));
  }
  return "";
}

}  // namespace fathom
