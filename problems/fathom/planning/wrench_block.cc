// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/wrench_block.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace fathom {
namespace {

constexpr double kShareOfOne = 0.4;  // of blocks that drive one axis, where there are several
constexpr double kShareOfTwo = 0.2;

// How many of `count` axes a block drives.
std::size_t DrawNumDriven(std::size_t count, RandomStream& random) {
  const double choice = random.Uniform();
  if (choice < kShareOfOne) return 1;
  return choice < kShareOfOne + kShareOfTwo ? std::min<std::size_t>(2, count) : count;
}

CommandBlock HeldAxis(const WrenchAxis& axis, int num_cells) {
  return {.kind = axis.holding == 0.0 ? BlockKind::kCoast : BlockKind::kStep,
          .num_cells = num_cells,
          .level = axis.holding};
}

}  // namespace

WrenchBlock HeldBlock(const std::vector<WrenchAxis>& axes, int num_cells) {
  WrenchBlock block = {num_cells, {}};
  for (const WrenchAxis& axis : axes) block.along.push_back(HeldAxis(axis, num_cells));
  return block;
}

WrenchBlock DrawWrenchBlock(const std::vector<WrenchAxis>& axes,
                            int num_cells,
                            int longest_hold,
                            RandomStream& random) {
  if (axes.size() == 1) {
    return {num_cells, {DrawBlock({axes.front().force, longest_hold}, num_cells, random)}};
  }
  WrenchBlock block = HeldBlock(axes, num_cells);
  std::vector<std::size_t> order(axes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::size_t num_driven = DrawNumDriven(axes.size(), random);
  for (std::size_t i = 0; i < num_driven; ++i) {
    const auto rest = static_cast<double>(axes.size() - i);
    const std::size_t other = i + static_cast<std::size_t>(random.Uniform() * rest);
    std::swap(order[i], order[std::min(other, axes.size() - 1)]);
    block.along[order[i]] = DrawBlock({axes[order[i]].force, longest_hold}, num_cells, random);
  }
  return block;
}

int NumCells(const std::vector<WrenchBlock>& blocks) {
  int sum = 0;
  for (const WrenchBlock& block : blocks) sum += block.num_cells;
  return sum;
}

std::vector<double> ForcesAlong(const std::vector<WrenchBlock>& blocks, std::size_t axis) {
  std::vector<double> forces;
  for (const WrenchBlock& block : blocks) {
    const std::vector<double> part = ForcesOf(block.along[axis]);
    forces.insert(forces.end(), part.begin(), part.end());
  }
  return forces;
}

CoupledCommand CommandOf(const std::vector<WrenchAxis>& axes,
                         const std::vector<WrenchBlock>& blocks,
                         double hold) {
  CoupledCommand command;
  command.force.assign(static_cast<std::size_t>(NumCells(blocks)) + 1, Vector6::Zero());
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    const std::vector<double> forces = ForcesAlong(blocks, axis);
    HeldCommand of_axis = CommandOfCells(forces, hold);
    for (std::size_t i = 0; i < forces.size(); ++i) {
      command.force[i][Index(axes[axis].dof)] = forces[i];
    }
    command.time = std::move(of_axis.time);
  }
  return command;
}

}  // namespace fathom
