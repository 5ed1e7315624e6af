// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/report/large_residual.h"

#include <cmath>

namespace fathom {

std::optional<double> LargeResidual(const Diagnosis& diagnosis) {
  constexpr double kLargeShare = 0.2;
  // Of a number and NaN fmax() gives the number.
  const double nmae = std::fmax(diagnosis.extended.train.nmae, diagnosis.extended.held_out.nmae);
  if (!(nmae > kLargeShare)) return std::nullopt;
  return nmae;
}

bool AreUnconfirmed(const Diagnosis& diagnosis) {
  return !diagnosis.causes.empty() &&
         (diagnosis.held_out_gain_low <= 0.0 || diagnosis.held_out_gain < 0.0);
}

bool AreContradicted(const Diagnosis& diagnosis) {
  return !diagnosis.causes.empty() && diagnosis.held_out_gain < 0.0;
}

}  // namespace fathom
