// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/command_search.h"

#include "fathom/base/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

namespace fathom {
namespace {

constexpr double kLongestBlock = 30.0;        // [s]
constexpr double kLongestShareOfPlan = 0.25;  // of one block
constexpr int kMostTrialsOfChange = 6;
constexpr int kNumRounds = 4;       // of improving the best start
constexpr double kNarrower = 0.98;  // of limits
constexpr int kMostNarrowings = 12;
constexpr int kEnoughKept = 10;  // changes that keep narrower limits

using Blocks = std::vector<WrenchBlock>;

Blocks With(Blocks blocks, const WrenchBlock& block) {
  blocks.push_back(block);
  return blocks;
}

void SetLength(int num_cells, WrenchBlock* block) {
  block->num_cells = num_cells;
  for (CommandBlock& along : block->along) along.num_cells = num_cells;
}

class CommandSearch {
 public:
  // `start`: each draws random numbers of its own.
  CommandSearch(const CommandTask& task, int start)
      : task_(task),
        judge_(task.judge(1.0)),
        random_(task.seed, fmt::format("planning.search.{}", start)),
        num_cells_(std::max(1, static_cast<int>(std::round(task.duration / task.hold)))) {
    const double longest = std::min(kLongestBlock, kLongestShareOfPlan * task.duration);
    longest_block_ = std::clamp(static_cast<int>(longest / task.hold), 1, num_cells_);
  }

  // A first command, block by block; without blocks if none keeps the limits.
  FoundCommand Build() {
    FoundCommand built = {{}, judge_->WorthOf({})};
    while (NumCells(built.blocks) < num_cells_) {
      if (!Extend(&built)) return {};
    }
    return built;
  }

  // Tries so many changes of a command, each kept if it is worth more. Then narrows the limits
  // until the other models keep them too; no blocks if they never do.
  void Improve(int num_moves, FoundCommand* found) {
    const FoundCommand before = *found;
    for (int move = 0; move < num_moves; ++move) TryChange(found);
    for (int i = 0; !found->blocks.empty() && !task_.is_kept_by_others(found->blocks); ++i) {
      *found = i < kMostNarrowings ? UnderNarrowerLimits(*found, before) : FoundCommand{};
    }
  }

 private:
  // Uniform in its logarithm: many short ones, few long ones.
  int DrawLength(int most) {
    const double drawn = std::exp(random_.Uniform() * std::log(most + 1.0));
    return std::clamp(static_cast<int>(drawn), 1, most);
  }

  std::size_t DrawPlace(std::size_t count) {
    return std::min(count - 1,
                    static_cast<std::size_t>(random_.Uniform() * static_cast<double>(count)));
  }

  WrenchBlock Draw(int num_cells) {
    return judge_->Given(
        DrawWrenchBlock(task_.axes, num_cells, std::max(1, longest_block_ / 2), random_));
  }

  // Behind the blocks, the vehicle is left where it is to the end.
  Blocks WithRest(const Blocks& blocks) const {
    const int rest = num_cells_ - NumCells(blocks);
    return rest > 0 ? With(blocks, HeldBlock(task_.axes, rest)) : blocks;
  }

  // One block more: the one that is worth most for its length, of those from which the vehicle can
  // still be stopped within the limits. False if there is none.
  bool Extend(FoundCommand* built) {
    struct Drawn {
      double gain = 0.0;  // of a cell
      double value = 0.0;
      WrenchBlock block;
    };
    const int most = std::min(num_cells_ - NumCells(built->blocks), longest_block_);
    std::vector<Drawn> drawn;
    for (int i = 0; i < task_.drawn_per_block; ++i) {
      const WrenchBlock block = Draw(DrawLength(most));
      const Blocks extended = With(built->blocks, block);
      // A run without derivatives costs a sixth.
      if (!judge_->KeptByOne(WithRest(extended))) continue;
      const double value = judge_->WorthOf(extended);
      if (!std::isfinite(value)) continue;
      drawn.push_back({(value - built->value) / block.num_cells, value, block});
    }
    std::stable_sort(
        drawn.begin(), drawn.end(), [](const auto& a, const auto& b) { return a.gain > b.gain; });
    for (const Drawn& candidate : drawn) {
      Blocks extended = With(built->blocks, candidate.block);
      if (!judge_->KeptByAll(WithRest(extended))) continue;
      *built = {std::move(extended), candidate.value};
      return true;
    }
    Blocks held = With(built->blocks, HeldBlock(task_.axes, most));
    if (!judge_->KeptByAll(WithRest(held))) return false;
    const double value = judge_->WorthOf(held);
    *built = {std::move(held), value};
    return true;
  }

  // Takes one change of the command if it is worth more. It costs little to see that a model breaks
  // a limit: another change takes its place.
  void TryChange(FoundCommand* found) {
    for (int trial = 0; trial < kMostTrialsOfChange; ++trial) {
      Blocks changed = Changed(found->blocks);
      if (!judge_->KeptByOne(changed)) continue;
      const double value = judge_->WorthOf(changed);
      if (value > found->value && judge_->KeptByAll(changed)) {
        *found = {std::move(changed), value};
      }
      return;
    }
  }

  // The change of a command that is worth most, of the first that keep narrower limits. If none
  // does, the command before, where others keep it, or another one.
  FoundCommand UnderNarrowerLimits(const FoundCommand& found, const FoundCommand& before) {
    share_ *= kNarrower;
    judge_ = task_.judge(share_);
    FoundCommand best;
    int num_kept = 0;
    for (int i = 0; i < task_.num_moves && num_kept < kEnoughKept; ++i) {
      Blocks changed = Changed(found.blocks);
      if (!judge_->KeptByAll(changed)) continue;
      ++num_kept;
      const double value = judge_->WorthOf(changed);
      if (value > best.value) best = {std::move(changed), value};
    }
    if (!best.blocks.empty()) return best;
    return task_.is_kept_by_others(before.blocks) ? before : Build();
  }

  Blocks Changed(Blocks blocks) {
    const std::size_t place = DrawPlace(blocks.size());
    const double choice = random_.Uniform();
    if (choice < 0.3) {
      blocks[place] = Redrawn(std::move(blocks[place]));
    } else if (choice < 0.6) {
      ChangeLevel(&blocks[place]);
    } else if (choice < 0.8) {
      MoveBorder(place, &blocks);
    } else if (choice < 0.9) {
      Split(place, &blocks);
    } else {
      std::swap(blocks[place], blocks[DrawPlace(blocks.size())]);
    }
    return blocks;
  }

  // Of one axis alone as often as of all.
  WrenchBlock Redrawn(WrenchBlock block) {
    if (task_.axes.size() == 1 || random_.Uniform() < 0.5) return Draw(block.num_cells);
    const std::size_t axis = DrawPlace(task_.axes.size());
    block.along[axis] = DrawBlock(
        {task_.axes[axis].force, std::max(1, longest_block_ / 2)}, block.num_cells, random_);
    return judge_->Given(std::move(block));
  }

  // Of one axis.
  void ChangeLevel(WrenchBlock* block) {
    const std::size_t axis = task_.axes.size() == 1 ? 0 : DrawPlace(task_.axes.size());
    const double force = task_.axes[axis].force;
    const double step = kLevelStep * force;
    CommandBlock& along = block->along[axis];
    if (along.kind == BlockKind::kCoast) along.kind = BlockKind::kStep;
    const double least = along.kind == BlockKind::kStep ? -force : step;
    along.level += std::round(4.0 * random_.Normal()) * step;
    along.level = std::clamp(along.level, least, force);
    if (along.level == 0.0) along.kind = BlockKind::kCoast;
    *block = judge_->Given(std::move(*block));
  }

  // Between the block and the next; one that keeps no cell is gone.
  void MoveBorder(std::size_t place, Blocks* blocks) {
    if (place + 1 >= blocks->size()) return;
    WrenchBlock& left = (*blocks)[place];
    WrenchBlock& right = (*blocks)[place + 1];
    const int wanted = static_cast<int>(std::round(0.1 * longest_block_ * random_.Normal()));
    int change = wanted == 0 ? (random_.Uniform() < 0.5 ? -1 : 1) : wanted;
    change = std::clamp(change, -left.num_cells, right.num_cells);
    SetLength(left.num_cells + change, &left);
    SetLength(right.num_cells - change, &right);
    std::erase_if(*blocks, [](const WrenchBlock& block) { return block.num_cells == 0; });
  }

  // Puts a new block in place of the block's end.
  void Split(std::size_t place, Blocks* blocks) {
    WrenchBlock& block = (*blocks)[place];
    if (block.num_cells < 2) return;
    const WrenchBlock added = Draw(DrawLength(block.num_cells - 1));
    SetLength(block.num_cells - added.num_cells, &block);
    blocks->insert(blocks->begin() + static_cast<std::ptrdiff_t>(place) + 1, added);
  }

  const CommandTask& task_;
  double share_ = 1.0;  // of the limits of motion
  std::unique_ptr<CommandJudge> judge_;
  RandomStream random_;
  int num_cells_ = 1;
  int longest_block_ = 1;
};

}  // namespace

FoundCommand SearchCommand(const CommandTask& task) {
  std::vector<FoundCommand> starts(static_cast<std::size_t>(task.num_starts));
  ParallelFor(task.num_starts, [&](int start) {
    CommandSearch search(task, start);
    FoundCommand& found = starts[static_cast<std::size_t>(start)];
    found = search.Build();
    if (!found.blocks.empty()) search.Improve(task.num_moves_of_start, &found);
  });
  FoundCommand best = *std::max_element(
      starts.begin(), starts.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
  CommandSearch search(task, task.num_starts);
  // In rounds, so that the rest makes good what narrower limits cost.
  for (int round = 0; round < kNumRounds && !best.blocks.empty(); ++round) {
    search.Improve(task.num_moves / kNumRounds, &best);
  }
  return best;
}

}  // namespace fathom
