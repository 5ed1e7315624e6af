// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled_planning/wrench_search.h"

#include "fathom/base/parallel_for.h"
#include "fathom/coupled_planning/given_block.h"
#include "fathom/coupled_planning/kept_wrench.h"
#include "fathom/planning/information.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kLongestWrench = 30.0;        // of one block [s]
constexpr double kLongestShareOfWrench = 0.2;  // of the plan
constexpr int kMostTrialsOfMove = 6;
constexpr int kMovesOverThoseOfStart = 5;  // of the best start
constexpr double kShareOfEntries = 0.3;    // beside rivals

using WrenchBlocks = std::vector<WrenchBlock>;

class WrenchSearch {
 public:
  // `start`: each draws random numbers of its own.
  WrenchSearch(const WrenchTask& task, int start)
      : task_(task),
        random_(task.seed, fmt::format("planning.wrench.{}", start)),
        hold_(task.limits.shortest_hold),
        num_cells_(std::max(1, static_cast<int>(std::round(task.duration / hold_)))),
        kept_(task.models, task.limits, num_cells_ * hold_),
        information_(task.models.front(), task.entries, task.measurement) {
    const double longest = std::min(kLongestWrench, kLongestShareOfWrench * task.duration);
    longest_block_ = std::clamp(static_cast<int>(longest / hold_), 1, num_cells_);
  }

  // A first command, block by block; without blocks if none keeps the limits.
  FoundWrench Build() {
    WrenchBlocks blocks;
    while (NumCells(blocks) < num_cells_) {
      if (!Extend(&blocks)) return {};
    }
    const double value = MeasureOf(blocks);
    return {std::move(blocks), value, {}};
  }

  // Tries so many changes of a command, each kept if it is worth more.
  void Improve(int num_moves, FoundWrench* found) {
    for (int move = 0; move < num_moves; ++move) {
      WrenchBlocks changed = Changed(found->blocks);
      bool is_kept = IsKeptByFirst(AsCommand(changed));
      // It costs little to see that a limit is broken.
      for (int trial = 1; trial < kMostTrialsOfMove && !is_kept; ++trial) {
        changed = Changed(found->blocks);
        is_kept = IsKeptByFirst(AsCommand(changed));
      }
      if (!is_kept) continue;
      const double value = MeasureOf(changed);
      if (!(value > found->value) || !kept_.KeptByAll(AsCommand(changed))) continue;
      found->before.push_back(std::move(found->blocks));
      found->blocks = std::move(changed);
      found->value = value;
    }
  }

 private:
  double MeasureOf(const WrenchBlocks& blocks) {
    const auto told = information_.Of(AsCommand(blocks), NumCells(blocks) * hold_);
    return told ? WorthOf(*told) : -std::numeric_limits<double>::infinity();
  }

  double WorthOf(const Eigen::MatrixXd& told) const {
    const Eigen::Index num_of_model = task_.so_far.rows();
    const double of_entries =
        LogDetOf(told.topLeftCorner(num_of_model, num_of_model) + task_.so_far);
    if (task_.rivals.empty()) return of_entries;
    return WorthOfSigmas(SigmasOf(task_.rivals, num_of_model, told)) +
           kShareOfEntries * of_entries / static_cast<double>(num_of_model);
  }

  // Of no command.
  double WorthOfNone() const {
    const auto size = static_cast<Eigen::Index>(task_.entries.size());
    return WorthOf(Eigen::MatrixXd::Zero(size, size));
  }

  CoupledCommand AsCommand(const WrenchBlocks& blocks) const {
    return CommandOf(task_.axes, blocks, hold_);
  }

  // Given by the thrusters, and kept within the limits by the first model.
  bool IsKeptByFirst(const CoupledCommand& command) {
    return (!task_.thrusters || task_.thrusters->Gives(command)) && kept_.KeptByFirst(command);
  }

  void LowerToThrustersOfTask(WrenchBlock* block) const {
    if (task_.thrusters) LowerToThrusters(task_.axes, *task_.thrusters, block);
  }

  // Uniform in its logarithm: many short ones, few long ones.
  int DrawLength(int most) {
    return std::clamp(
        static_cast<int>(std::exp(random_.Uniform() * std::log(most + 1.0))), 1, most);
  }

  WrenchBlock Draw(int num_cells) {
    WrenchBlock block =
        DrawWrenchBlock(task_.axes, num_cells, std::max(1, longest_block_ / 2), random_);
    LowerToThrustersOfTask(&block);
    return block;
  }

  // With one more, behind which the vehicle is left where it is to the end.
  WrenchBlocks With(WrenchBlocks blocks, const WrenchBlock& block) const {
    blocks.push_back(block);
    return blocks;
  }
  WrenchBlocks WithRest(const WrenchBlocks& blocks) const {
    const int rest = num_cells_ - NumCells(blocks);
    return rest > 0 ? With(blocks, HeldBlock(task_.axes, rest)) : blocks;
  }

  // One block more: the one that is worth most for its length, of those from which the vehicle can
  // still be stopped within the limits. False if there is none.
  bool Extend(WrenchBlocks* blocks) {
    const int most = std::min(num_cells_ - NumCells(*blocks), longest_block_);
    const double so_far = blocks->empty() ? WorthOfNone() : MeasureOf(*blocks);
    std::vector<std::pair<double, WrenchBlock>> drawn;
    for (int i = 0; i < task_.drawn_per_block; ++i) {
      const WrenchBlock block = Draw(DrawLength(most));
      const WrenchBlocks extended = With(*blocks, block);
      if (!IsKeptByFirst(AsCommand(WithRest(extended)))) continue;
      const double value = MeasureOf(extended);
      if (std::isfinite(value)) drawn.emplace_back((value - so_far) / block.num_cells, block);
    }
    std::stable_sort(
        drawn.begin(), drawn.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    drawn.emplace_back(0.0, HeldBlock(task_.axes, most));
    for (const auto& [gain, block] : drawn) {
      WrenchBlocks extended = With(*blocks, block);
      if (!kept_.KeptByAll(AsCommand(WithRest(extended)))) continue;
      *blocks = std::move(extended);
      return true;
    }
    return false;
  }

  std::size_t DrawPlaceOf(std::size_t count) {
    return std::min(count - 1,
                    static_cast<std::size_t>(random_.Uniform() * static_cast<double>(count)));
  }

  WrenchBlocks Changed(WrenchBlocks blocks) {
    const std::size_t place = DrawPlaceOf(blocks.size());
    WrenchBlock& block = blocks[place];
    const double choice = random_.Uniform();
    if (choice < 0.3) {
      block = Draw(block.num_cells);
    } else if (choice < 0.6) {
      ChangeAxis(&block);
      LowerToThrustersOfTask(&block);
    } else if (choice < 0.75) {
      MoveBorderBehind(place, &blocks);
    } else if (choice < 0.9 && block.num_cells > 1) {
      const WrenchBlock added = Draw(DrawLength(block.num_cells - 1));
      SetLength(block.num_cells - added.num_cells, &block);
      blocks.insert(blocks.begin() + static_cast<std::ptrdiff_t>(place) + 1, added);
    } else {
      std::swap(block, blocks[DrawPlaceOf(blocks.size())]);
    }
    return blocks;
  }

  static void SetLength(int num_cells, WrenchBlock* block) {
    block->num_cells = num_cells;
    for (CommandBlock& along : block->along) along.num_cells = num_cells;
  }

  // Another level of one axis, or another block.
  void ChangeAxis(WrenchBlock* block) {
    const std::size_t axis = DrawPlaceOf(task_.axes.size());
    const double force = task_.axes[axis].force;
    CommandBlock& along = block->along[axis];
    if (random_.Uniform() < 0.4) {
      along = DrawBlock({force, std::max(1, longest_block_ / 2)}, block->num_cells, random_);
      return;
    }
    const double step = kLevelStep * force;
    if (along.kind == BlockKind::kCoast) along.kind = BlockKind::kStep;
    const double least = along.kind == BlockKind::kStep ? -force : step;
    along.level += std::round(4.0 * random_.Normal()) * step;
    along.level = std::clamp(along.level, least, force);
    if (along.level == 0.0) along.kind = BlockKind::kCoast;
  }

  // Between the block and the next; one that keeps no cell is gone.
  void MoveBorderBehind(std::size_t place, WrenchBlocks* blocks) {
    if (place + 1 >= blocks->size()) return;
    WrenchBlock& left = (*blocks)[place];
    WrenchBlock& right = (*blocks)[place + 1];
    const int wanted = static_cast<int>(std::round(0.2 * longest_block_ * random_.Normal()));
    int change = wanted == 0 ? (random_.Uniform() < 0.5 ? -1 : 1) : wanted;
    change = std::clamp(change, -left.num_cells, right.num_cells);
    SetLength(left.num_cells + change, &left);
    SetLength(right.num_cells - change, &right);
    std::erase_if(*blocks, [](const WrenchBlock& block) { return block.num_cells == 0; });
  }

  const WrenchTask& task_;
  RandomStream random_;
  double hold_;
  int num_cells_;
  int longest_block_ = 1;
  KeptWrench kept_;
  WrenchInformation information_;
};

}  // namespace

FoundWrench SearchWrench(const WrenchTask& task) {
  std::vector<FoundWrench> starts(static_cast<std::size_t>(task.num_starts));
  ParallelFor(task.num_starts, [&](int start) {
    WrenchSearch search(task, start);
    FoundWrench& found = starts[static_cast<std::size_t>(start)];
    found = search.Build();
    if (!found.blocks.empty()) search.Improve(task.num_moves / kMovesOverThoseOfStart, &found);
  });
  FoundWrench best = *std::max_element(
      starts.begin(), starts.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
  if (!best.blocks.empty()) WrenchSearch(task, task.num_starts).Improve(task.num_moves, &best);
  return best;
}

}  // namespace fathom
