// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "drawn_input.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <variant>
#include <vector>

#include "drawn_setup.h"

namespace fathom::hidden {
namespace {

// A stick: held at a level, let go, pushed the other way; each move takes a fraction of a second.
HeldCommand PilotCommand(double duration, double rate, Chance& chance) {
  HeldCommand command;
  double level = 0.0, target = 0.0, move_until = 0.0, hold_until = 0.0, start_level = 0.0,
         move_from = 0.0;
  for (int k = 0; k / rate < duration + 5.0; ++k) {
    const double t = k / rate;
    if (t >= hold_until) {
      start_level = level;
      const bool lets_go = chance.Is(0.3);
      target = lets_go ? 0.0 : chance.Sign() * chance.Uniform(0.2, 1.6);
      move_from = t;
      move_until = t + chance.Uniform(0.1, 0.6);
      hold_until = move_until + chance.LogUniform(1.0, 15.0);
    }
    level = t >= move_until
                ? target
                : start_level + (target - start_level) * (t - move_from) / (move_until - move_from);
    command.time.push_back(t);
    command.value.push_back(level);
  }
  return command;
}

StepsInput Steps(double duration, double time_constant, Chance& chance) {
  StepsInput steps;
  steps.hold = std::clamp(chance.Uniform(0.4, 2.0) * time_constant, 3.0, 30.0);
  const int num_levels = static_cast<int>(std::ceil(duration / steps.hold));
  for (int i = 0; i < num_levels; ++i) {
    steps.levels.push_back(chance.Is(0.15) ? 0.0 : chance.Sign() * chance.Uniform(0.3, 1.6));
  }
  return steps;
}

}  // namespace

DrawnInput DrawInput(double duration,
                     double rate,
                     double time_constant,
                     std::uint64_t seed,
                     const std::string& purpose) {
  Chance chance(seed, "hidden." + purpose);
  static const std::vector<std::string> kKinds = {"multisine",
                                                  "multisine",
                                                  "multisine",
                                                  "chirp",
                                                  "chirp",
                                                  "steps",
                                                  "steps",
                                                  "steps",
                                                  "prbs",
                                                  "prbs",
                                                  "pilot",
                                                  "pilot",
                                                  "pilot",
                                                  "sine"};
  DrawnInput drawn;
  drawn.kind = chance.OneOf(kKinds);
  const double highest = std::min(0.25 * rate, 1.0) * chance.Uniform(0.8, 2.5);  // [rad/s]
  if (drawn.kind == "multisine") {
    MultisineInput sines;
    sines.rms = 1.0;
    sines.lowest_frequency = chance.Uniform(0.03, 0.1);
    sines.highest_frequency = highest;
    sines.num_lines = 8 + chance.Index(25);
    drawn.input.kind = sines;
  } else if (drawn.kind == "chirp") {
    drawn.input.kind =
        ChirpInput{1.4, chance.Uniform(0.03, 0.1), highest, duration * chance.Uniform(0.2, 0.7)};
  } else if (drawn.kind == "steps") {
    drawn.input.kind = Steps(duration, time_constant, chance);
  } else if (drawn.kind == "prbs") {
    drawn.input.kind =
        PrbsInput{1.0, std::clamp(chance.Uniform(0.1, 0.6) * time_constant, 1.0, 15.0), 0};
  } else if (drawn.kind == "pilot") {
    drawn.input.kind = ReplayInput{"pilot", PilotCommand(duration, rate, chance)};
  } else {
    drawn.input.kind =
        SineInput{1.4, chance.Uniform(0.5, 2.0) / time_constant, chance.Uniform(0.0, 6.28)};
  }
  return drawn;
}

void Scale(InputSignal& input, double factor) {
  input.offset *= factor;
  std::visit(
      [factor](auto& kind) {
        using Kind = std::decay_t<decltype(kind)>;
        if constexpr (std::is_same_v<Kind, MultisineInput>) {
          kind.rms *= factor;
        } else if constexpr (std::is_same_v<Kind, StepsInput>) {
          for (double& level : kind.levels) level *= factor;
        } else if constexpr (std::is_same_v<Kind, ReplayInput>) {
          for (double& value : kind.command.value) value *= factor;
        } else {
          kind.amplitude *= factor;
        }
      },
      input.kind);
}

}  // namespace fathom::hidden
