// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/simulate/coupled/coupled_inputs.h"

#include <algorithm>

namespace fathom {

double RaceThrust(const CoupledCommand& command, const CommandedFin& fin, std::size_t row) {
  if (fin.behind.empty()) return 0.0;
  double of_it = 0.0, of_all = command.force.empty() ? 0.0 : command.force[row][0];
  bool is_named = false;
  for (const CommandedThruster& thruster : command.thrusters) {
    const double ahead = thruster.push[0] * thruster.thrust[row];
    of_all += ahead;
    if (thruster.name != fin.behind) continue;
    is_named = true;
    of_it = ahead;
  }
  return std::max(is_named ? of_it : of_all, 0.0);
}

}  // namespace fathom
