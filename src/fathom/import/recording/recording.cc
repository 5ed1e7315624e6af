// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/import/recording/recording.h"

#include <string_view>

namespace fathom {

void Contents::TellSimulation() {
  constexpr std::string_view kSetting = "SIM_";  // of SITL alone
  const auto first = parameters.lower_bound(std::string(kSetting));
  if (first == parameters.end() || !first->first.starts_with(kSetting)) return;
  remarks.emplace_back(
      "this is a simulation: ArduPilot's simulator (SITL) wrote it, as its settings SIM_... tell. "
      "A "
      "model of it is the simulator's.");
}

}  // namespace fathom
