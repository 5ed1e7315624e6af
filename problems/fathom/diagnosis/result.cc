// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/result.h"

#include "fathom/base/interval95.h"
#include "fathom/report/format_value.h"
#include "fathom/vehicle/parameters.h"

#include <cmath>

#include <fmt/format.h>

namespace fathom {

std::string WhyOfNoUse(const Diagnosis& diagnosis) {
  if (!diagnosis.IsUsable()) return diagnosis.message;
  if (diagnosis.verdict != Verdict::kConsistent) return "";
  const double inertia = diagnosis.baseline.model.baseline.inertia;
  const double variance = diagnosis.baseline.covariance(kInertia, kInertia);
  const double half_width = kStdsOf95 * std::sqrt(variance);
  if (half_width < inertia) return "";
  return fmt::format(
      "these logs do not determine the inertia: {:.3g} ± {:.2g} {} (95 %), and no cause that was "
      "tried changes this. Fast and large changes of the command determine it: steps, or a "
      "square wave with a period of 10 to 20 s.",
      inertia,
      half_width,
      UnitText(ParameterUnit(kInertia, diagnosis.dof, diagnosis.force_unit)));
}

bool AreUnconfirmed(const Diagnosis& diagnosis) {
  return !diagnosis.causes.empty() &&
         (diagnosis.held_out_gain_low <= 0.0 || diagnosis.held_out_gain < 0.0);
}

bool AreContradicted(const Diagnosis& diagnosis) {
  return !diagnosis.causes.empty() && diagnosis.held_out_gain < 0.0;
}

}  // namespace fathom
