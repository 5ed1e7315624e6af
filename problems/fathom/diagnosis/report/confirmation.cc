// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/diagnosis/report/confirmation.h"

namespace fathom {

bool AreUnconfirmed(const Diagnosis& diagnosis) {
  return !diagnosis.causes.empty() &&
         (diagnosis.held_out_gain_low <= 0.0 || diagnosis.held_out_gain < 0.0);
}

bool AreContradicted(const Diagnosis& diagnosis) {
  return !diagnosis.causes.empty() && diagnosis.held_out_gain < 0.0;
}

}  // namespace fathom
