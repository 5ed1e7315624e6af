// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/coupled_plan.h"

namespace fathom {

std::string_view Name(NoiseSource source) {
  switch (source) {
    case NoiseSource::kLog:
      return "log";
    case NoiseSource::kLogTakenAsWhite:
      return "log_taken_as_white";
    case NoiseSource::kLimits:
      break;
  }
  return "limits";
}

}  // namespace fathom
