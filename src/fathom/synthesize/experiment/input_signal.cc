// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/experiment/input_signal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>

#include <glog/logging.h>

namespace fathom {
namespace {

constexpr int kPrbsLength = 1023;

// Bits of x^10 + x^7 + 1, which runs through every state of ten bits but zero.
std::array<bool, kPrbsLength> MaximalLengthSequence() {
  std::array<bool, kPrbsLength> sequence{};
  unsigned state = 1;
  for (bool& bit : sequence) {
    bit = state & 1;
    const unsigned feedback = (state ^ (state >> 3)) & 1;
    state = (state >> 1) | (feedback << 9);
  }
  return sequence;
}

// How many whole pieces of `hold` seconds are over at t. The tiny part lets a stamp such as 0.3
// that stands just below 3 * 0.1 in binary count as the boundary it is meant to be.
std::size_t NumWholePieces(double t, double hold) {
  return static_cast<std::size_t>(std::floor(t / hold * (1.0 + 1e-12) + 1e-9));
}

struct ValueAt {
  double t;

  double operator()(const SineInput& sine) const {
    return sine.amplitude * std::sin(sine.frequency * t + sine.phase);
  }

  double operator()(const MultisineInput& sines) const {
    CHECK_EQ(sines.phases.size(), static_cast<std::size_t>(sines.num_lines));
    const double spacing =
        sines.num_lines == 1
            ? 0.0
            : (sines.highest_frequency - sines.lowest_frequency) / (sines.num_lines - 1);
    double sum = 0.0;
    for (int line = 0; line < sines.num_lines; ++line) {
      sum += std::sin((sines.lowest_frequency + line * spacing) * t + sines.phases[line]);
    }
    return sines.rms * std::sqrt(2.0 / sines.num_lines) * sum;
  }

  double operator()(const ChirpInput& chirp) const {
    const double s = std::fmod(t, chirp.sweep);
    const double rate = (chirp.last_frequency - chirp.first_frequency) / chirp.sweep;
    return chirp.amplitude * std::sin((chirp.first_frequency + 0.5 * rate * s) * s);
  }

  double operator()(const StepsInput& steps) const {
    CHECK(!steps.levels.empty());
    return steps.levels[NumWholePieces(t, steps.hold) % steps.levels.size()];
  }

  double operator()(const PrbsInput& prbs) const {
    static const auto sequence = MaximalLengthSequence();
    const std::size_t place = NumWholePieces(t, prbs.hold) + prbs.start;
    return sequence[place % kPrbsLength] ? prbs.amplitude : -prbs.amplitude;
  }

  double operator()(const SquareInput& square) const {
    const bool is_first_half = NumWholePieces(t, std::numbers::pi / square.frequency) % 2 == 0;
    return is_first_half ? square.amplitude : -square.amplitude;
  }

  double operator()(const PilotInput& pilot) const {
    CHECK(!pilot.moves.empty());
    const auto move = std::upper_bound(
        pilot.moves.begin(), std::prev(pilot.moves.end()), t, [](double at, const auto& other) {
          return at < other.end;
        });
    const double begin = move == pilot.moves.begin() ? 0.0 : std::prev(move)->end;
    const double share = std::min((t - begin) / (move->end - begin), 1.0);
    const double stick = move->from + share * (move->to - move->from);
    return pilot.amplitude * std::round(stick * pilot.num_levels) / pilot.num_levels;
  }

  double operator()(const RandomStepsInput& random) const {
    CHECK(!random.steps.empty());
    const auto step = std::upper_bound(
        random.steps.begin(), std::prev(random.steps.end()), t, [](double at, const auto& other) {
          return at < other.end;
        });
    return random.amplitude * step->level;
  }

  double operator()(const ReplayInput& replay) const {
    CHECK(!replay.command.time.empty());
    return replay.command.At(replay.command.time.front() + t);
  }
};

// Of a quarter each: back to rest, stay, move there at once, move there evenly.
void DrawMoves(PilotInput& pilot, double duration, RandomStream& random) {
  pilot.moves.clear();
  double stick = 0.0, last_side = random.Uniform() < 0.5 ? -1.0 : 1.0, end = 0.0;
  while (end <= duration) {
    // Four numbers a move, used or not.
    const double kind = 4.0 * random.Uniform();
    const double length = pilot.hold * (0.5 + random.Uniform());
    const double side = random.Uniform() < 0.7 ? -last_side : last_side;
    const double place = side * (0.2 + 0.8 * random.Uniform());
    end += length;
    const double next = kind < 1.0 ? 0.0 : kind < 2.0 ? stick : place;
    const bool is_even = kind >= 3.0;
    pilot.moves.push_back({end, is_even ? stick : next, next});
    if (kind >= 2.0) last_side = side;
    stick = next;
  }
}

// Levels and lengths, both even between their bounds.
void DrawSteps(RandomStepsInput& random_steps, double duration, RandomStream& random) {
  random_steps.steps.clear();
  double end = 0.0;
  while (end <= duration) {
    const double level = 2.0 * random.Uniform() - 1.0;
    end +=
        random_steps.shortest + (random_steps.longest - random_steps.shortest) * random.Uniform();
    random_steps.steps.push_back({end, level});
  }
}

}  // namespace

void DrawRandomParts(InputSignal& input, double duration, RandomStream& random) {
  if (auto* sines = std::get_if<MultisineInput>(&input.kind)) {
    sines->phases.clear();
    for (int line = 0; line < sines->num_lines; ++line) {
      sines->phases.push_back(2.0 * std::numbers::pi * random.Uniform());
    }
  } else if (auto* prbs = std::get_if<PrbsInput>(&input.kind)) {
    prbs->start = static_cast<int>(kPrbsLength * random.Uniform());
  } else if (auto* pilot = std::get_if<PilotInput>(&input.kind)) {
    DrawMoves(*pilot, duration, random);
  } else if (auto* random_steps = std::get_if<RandomStepsInput>(&input.kind)) {
    DrawSteps(*random_steps, duration, random);
  }
}

double Value(const InputSignal& input, double t) {
  return input.offset + std::visit(ValueAt{t}, input.kind);
}

}  // namespace fathom
