// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/ordinary_dives/ordinary_dives.h"

#include "fathom/base/interval95.h"

namespace fathom {

std::string_view Name(RemedyKind kind) {
  switch (kind) {
    case RemedyKind::kMoreOfTheSame:
      return "more_of_the_same";
    case RemedyKind::kManoeuvre:
      return "manoeuvre";
    case RemedyKind::kPosition:
      return "position";
    case RemedyKind::kFasterRate:
      return "faster_rate";
  }
  return "";
}

bool OrdinaryDives::DoesAsWellAsAll(const OrdinaryKnowledge& knowledge) const {
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const double half_interval = kStdsOf95 * knowledge.stds[i];
    if (half_interval <= kWellKnown * parameters[i].size) continue;
    if (!(knowledge.stds[i] <= kEnough * all.stds[i])) return false;
  }
  return true;
}

}  // namespace fathom
