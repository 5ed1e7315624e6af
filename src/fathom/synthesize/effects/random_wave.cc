// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/synthesize/effects/random_wave.h"

#include "fathom/base/random_stream.h"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace fathom {
namespace {

struct Line {
  double frequency;
  double phase;
};

std::array<Line, 64> DrawLines(std::uint64_t realisation) {
  RandomStream random(realisation, "random_wave");
  std::array<Line, 64> lines;
  for (Line& line : lines) {
    line.frequency = std::tan(std::numbers::pi * (random.Uniform() - 0.5));
    line.phase = 2.0 * std::numbers::pi * random.Uniform();
  }
  return lines;
}

}  // namespace

double RandomWaveAt(std::uint64_t realisation, double s) {
  // The lines of the last one asked for: an effect asks for the same a million times.
  thread_local std::optional<std::uint64_t> last;
  thread_local std::array<Line, 64> lines;
  if (last != realisation) lines = DrawLines(realisation);
  last = realisation;
  double sum = 0.0;
  for (const Line& line : lines) sum += std::cos(line.frequency * s + line.phase);
  return std::sqrt(2.0 / lines.size()) * sum;
}

}  // namespace fathom
