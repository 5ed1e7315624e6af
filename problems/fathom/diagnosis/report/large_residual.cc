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

}  // namespace fathom
