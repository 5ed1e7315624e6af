// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/command_block.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace fathom {
namespace {

constexpr int kNumLines = 5;  // of a multisine

// 0 to count - 1.
int DrawIndex(int count, RandomStream& random) {
  return std::min(count - 1, static_cast<int>(random.Uniform() * count));
}

std::uint64_t DrawSeed(RandomStream& random) {
  return static_cast<std::uint64_t>(random.Uniform() * 4294967296.0);
}

// 1 to `greatest`, uniform in its logarithm.
int DrawCount(int greatest, RandomStream& random) {
  const double count = std::exp(random.Uniform() * std::log(greatest + 1.0));
  return std::clamp(static_cast<int>(count), 1, greatest);
}

std::vector<double> TelegraphForces(const CommandBlock& block) {
  RandomStream random(block.seed, "planning.telegraph");
  std::vector<double> forces;
  double sign = 1.0;
  for (int cell = 0; cell < block.num_cells; ++cell) {
    if (cell % block.hold_cells == 0) sign = random.Uniform() < 0.5 ? -1.0 : 1.0;
    forces.push_back(sign * block.level);
  }
  return forces;
}

// Lines evenly from one period in the block to a half period of hold_cells, or the slowest alone.
std::vector<double> MultisineForces(const CommandBlock& block) {
  RandomStream random(block.seed, "planning.multisine");
  const double slowest = 2.0 * std::numbers::pi / block.num_cells;  // [rad/cell]
  const double fastest = std::max(slowest, std::numbers::pi / (block.hold_cells + 1));
  std::array<double, kNumLines> phases{};
  for (double& phase : phases) phase = 2.0 * std::numbers::pi * random.Uniform();
  std::vector<double> forces;
  double peak = 1e-9;  // so that silence stays silence
  for (int cell = 0; cell < block.num_cells; ++cell) {
    double sum = 0.0;
    for (int line = 0; line < kNumLines; ++line) {
      const double frequency = slowest + (fastest - slowest) * line / (kNumLines - 1);
      sum += std::sin(frequency * (cell + 0.5) + phases[line]);
    }
    forces.push_back(sum);
    peak = std::max(peak, std::abs(sum));
  }
  // Three decimals of the peak: what a file holds is what acts.
  for (double& force : forces) force = block.level * std::round(1000.0 * force / peak) / 1000.0;
  return forces;
}

}  // namespace

std::string_view Name(BlockKind kind) {
  switch (kind) {
    case BlockKind::kStep:
      return "step";
    case BlockKind::kCoast:
      return "coast";
    case BlockKind::kTelegraph:
      return "telegraph";
    case BlockKind::kMultisine:
      break;
  }
  return "multisine";
}

CommandBlock DrawBlock(const BlockRange& range, int num_cells, RandomStream& random) {
  CommandBlock block = {.num_cells = num_cells};
  // Steps are what limits leave most of, so they are drawn as often as all others together.
  const double kind = random.Uniform();
  const int num_levels = static_cast<int>(std::round(1.0 / kLevelStep));
  block.level = range.force * (1 + DrawIndex(num_levels, random)) / num_levels;
  block.hold_cells = DrawCount(std::min(range.longest_hold, num_cells), random);
  block.seed = DrawSeed(random);
  if (kind < 0.5) {
    block.kind = BlockKind::kStep;
    if (random.Uniform() < 0.5) block.level = -block.level;
  } else if (kind < 0.6) {
    block.kind = BlockKind::kCoast;
    block.level = 0.0;
  } else {
    block.kind = kind < 0.8 ? BlockKind::kTelegraph : BlockKind::kMultisine;
  }
  return block;
}

std::vector<double> ForcesOf(const CommandBlock& block) {
  switch (block.kind) {
    case BlockKind::kStep:
      return std::vector<double>(block.num_cells, block.level);
    case BlockKind::kCoast:
      return std::vector<double>(block.num_cells, 0.0);
    case BlockKind::kTelegraph:
      return TelegraphForces(block);
    case BlockKind::kMultisine:
      break;
  }
  return MultisineForces(block);
}

HeldCommand CommandOfCells(const std::vector<double>& forces, double hold) {
  HeldCommand command;
  for (std::size_t cell = 0; cell <= forces.size(); ++cell) {
    // To the microsecond, as logs have their stamps.
    command.time.push_back(std::round(1e6 * hold * static_cast<double>(cell)) / 1e6);
    command.value.push_back(cell < forces.size() ? forces[cell] : 0.0);
  }
  return command;
}

}  // namespace fathom
