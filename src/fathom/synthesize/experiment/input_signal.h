// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "fathom/base/random_stream.h"
#include "fathom/log/held_command.h"

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace fathom {

// What drives a DOF, over the time t since the start of the experiment [s]: a force in open loop, a
// position in closed loop. Amplitudes are in its unit: [N], [N m], [m] or [rad]; docs/synthesize.md
// (1) to (6), (11) and (12).

// amplitude * sin(frequency * t + phase)
struct SineInput {
  double amplitude = 0.0;
  double frequency = 0.0;  // [rad/s]
  double phase = 0.0;      // [rad]
};

// A sum of sines of equal amplitude, at num_lines frequencies evenly from lowest to highest.
struct MultisineInput {
  double rms = 0.0;                // over a common period of the lines
  double lowest_frequency = 0.0;   // [rad/s]
  double highest_frequency = 0.0;  // [rad/s]
  int num_lines = 1;
  std::vector<double> phases;  // [rad], one for each line; drawn by DrawRandomParts
};

// A sine whose frequency runs linearly from one to the other in `sweep` seconds, then again.
struct ChirpInput {
  double amplitude = 0.0;
  double first_frequency = 0.0;  // [rad/s]
  double last_frequency = 0.0;   // [rad/s]
  double sweep = 1.0;            // [s], above 0
};

// One level after the other, each for `hold` seconds; from the start again after the last.
struct StepsInput {
  std::vector<double> levels;  // at least one
  double hold = 1.0;           // [s], above 0
};

// Pseudo-random binary sequence of length 1023: +amplitude or -amplitude for `hold` seconds each.
struct PrbsInput {
  double amplitude = 0.0;
  double hold = 1.0;  // [s], above 0
  int start = 0;      // place in the sequence at t = 0; drawn by DrawRandomParts
};

// +amplitude in the first half of each period, -amplitude in the second.
struct SquareInput {
  double amplitude = 0.0;
  double frequency = 0.0;  // [rad/s]
};

// A person at a joystick: the stick rests at zero, is held, or is moved evenly to a new place, each
// for some time about `hold`; it leans to the side away from the last. Its places are multiples of
// amplitude / num_levels, up to +amplitude or -amplitude.
struct PilotInput {
  struct Move {
    double end = 0.0;   // when it is over [s]
    double from = 0.0;  // of the amplitude, -1 to 1
    double to = 0.0;
  };

  double amplitude = 0.0;
  double hold = 1.0;  // [s], above 0
  int num_levels = 10;
  std::vector<Move> moves;  // drawn by DrawRandomParts
};

// One level after the other, each for a time of its own.
struct RandomStepsInput {
  struct Step {
    double end = 0.0;    // when it is over [s]
    double level = 0.0;  // of the amplitude, -1 to 1
  };

  double amplitude = 0.0;        // of the largest level
  double shortest = 1.0;         // [s], above 0
  double longest = 1.0;          // [s], at least shortest
  std::vector<Step> steps = {};  // drawn by DrawRandomParts
};

// A recorded command, its first stamp at t = 0.
struct ReplayInput {
  std::filesystem::path file;
  HeldCommand command;  // read from the file
};

struct InputSignal {
  double offset = 0.0;  // added to the value
  std::variant<SineInput,
               MultisineInput,
               ChirpInput,
               StepsInput,
               PrbsInput,
               SquareInput,
               PilotInput,
               ReplayInput,
               RandomStepsInput>
      kind;
};

// Draws what the seed decides: the phases of a multisine, the start of a PRBS, a pilot's moves and
// random steps from 0 to `duration` [s].
void DrawRandomParts(InputSignal& input, double duration, RandomStream& random);

// Value at time t since the start of the experiment [s], t >= 0.
double Value(const InputSignal& input, double t);

}  // namespace fathom
