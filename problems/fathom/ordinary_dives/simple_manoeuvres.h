// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/log/held_command.h"
#include "fathom/vehicle/fitted_model.h"

#include <string>
#include <vector>

namespace fathom {

// What a pilot flies by hand when told in a sentence.
struct SimpleManoeuvre {
  std::string words;    // "20 N ahead for 8 s, then as long back, over and over"
  HeldCommand command;  // from t = 0 on
};

// Forces held as long as the speed takes to settle, and a quarter of that; coasts; stairs. Each as
// great as `force`, or less where the model would pass `speed`; both positive. Those under which
// the model diverges are left out.
std::vector<SimpleManoeuvre> SimpleManoeuvres(const FittedModel& model,
                                              double force,
                                              double speed,
                                              double duration);

}  // namespace fathom
