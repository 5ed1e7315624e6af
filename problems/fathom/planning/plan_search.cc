// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/planning/plan_search.h"

#include "fathom/base/parallel_for.h"
#include "fathom/planning/kept_limits.h"
#include "fathom/planning/planned_motion.h"

#include <algorithm>
#include <cmath>
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
constexpr int kMostTrialsOfNarrowing = 2000;  // for so many changes that keep narrower limits:
constexpr int kEnoughKept = 10;

using Blocks = std::vector<CommandBlock>;

int NumCells(const Blocks& blocks) {
  int sum = 0;
  for (const CommandBlock& block : blocks) sum += block.num_cells;
  return sum;
}

class CommandSearch {
 public:
  // `start`: each draws random numbers of its own.
  CommandSearch(const CommandTask& task, int start)
      : task_(task),
        limits_(task.limits),
        models_(task.models),
        random_(task.seed, fmt::format("planning.search.{}", start)) {
    const double hold = task.limits.shortest_hold;
    num_cells_ = std::max(1, static_cast<int>(std::round(task.duration / hold)));
    const double longest = std::min(kLongestBlock, kLongestShareOfPlan * task.duration);
    longest_block_ = std::clamp(static_cast<int>(longest / hold), 1, num_cells_);
    range_ = {task.limits.force, std::max(1, longest_block_ / 2)};
    stamps_ = PlannedStamps(num_cells_ * hold, task.period);
    stamps_and_after_ = PlannedStamps(num_cells_ * hold + kCoastAfterwards, task.period);
  }

  // A first command, block by block; without blocks if none keeps the limits.
  FoundCommand Build() {
    FoundCommand found;
    Blocks blocks;
    double value = task_.measure({}, {});
    while (NumCells(blocks) < num_cells_) {
      if (!Extend(&blocks, &value)) return found;
    }
    found.blocks = std::move(blocks);
    found.value = MeasureOf(found.blocks);
    return found;
  }

  // Tries so many changes of a command, each kept if it is worth more. Then narrows the limits
  // until the other models keep them too; no blocks if they never do.
  void Improve(int num_moves, FoundCommand* found) {
    const FoundCommand before = *found;
    for (int move = 0; move < num_moves; ++move) TryChange(found);
    for (int i = 0; !found->blocks.empty() && !IsKeptByOthers(*found); ++i) {
      *found = i < kMostNarrowings ? UnderNarrowerLimits(*found, before) : FoundCommand{};
    }
  }

 private:
  // Uniform in its logarithm: many short ones, few long ones.
  int DrawLength(int most) {
    const double drawn = std::exp(random_.Uniform() * std::log(most + 1.0));
    return std::clamp(static_cast<int>(drawn), 1, most);
  }

  HeldCommand CommandOf(const Blocks& blocks) const {
    return CommandOfCells(ForcesOf(blocks), task_.limits.shortest_hold);
  }

  // The stamps until the blocks end.
  std::span<const double> StampsOf(const Blocks& blocks) const {
    const double end = NumCells(blocks) * task_.limits.shortest_hold;
    return {stamps_.begin(), std::upper_bound(stamps_.begin(), stamps_.end(), end + 1e-9)};
  }

  double MeasureOf(const Blocks& blocks) const {
    return task_.measure(CommandOf(blocks), StampsOf(blocks));
  }

  // Whether the first so many models keep the limits. One that does not is asked first from then
  // on.
  bool IsKeptByFirst(std::size_t num_models, const Blocks& blocks, std::span<const double> stamps) {
    const HeldCommand command = CommandOf(blocks);
    const auto end = models_.begin() + static_cast<std::ptrdiff_t>(num_models);
    const auto breaking = std::find_if(models_.begin(), end, [&](const ExtendedModel& model) {
      const auto motion = MotionUnder(model, task_.dof, command, stamps);
      return !motion || !KeepsLimits(*motion, limits_);
    });
    if (breaking == end) return true;
    std::rotate(models_.begin(), breaking, breaking + 1);
    return false;
  }

  bool IsKeptByAll(const Blocks& blocks) {
    return IsKeptByFirst(models_.size(), blocks, stamps_and_after_);
  }

  bool IsKeptByOthers(const FoundCommand& found) const {
    return task_.is_kept_by_others(CommandOf(found.blocks));
  }

  // Behind the blocks, the vehicle is left where it is to the end.
  Blocks WithRest(Blocks blocks) const {
    const int rest = num_cells_ - NumCells(blocks);
    if (rest > 0) {
      blocks.push_back({.kind = BlockKind::kStep, .num_cells = rest, .level = task_.holding_force});
    }
    return blocks;
  }

  // One block more: the one that is worth most for its length, of those from which the vehicle can
  // still be stopped within the limits. False if there is none.
  bool Extend(Blocks* blocks, double* value) {
    const int rest = num_cells_ - NumCells(*blocks);
    std::vector<std::pair<double, CommandBlock>> drawn;
    for (int i = 0; i < task_.drawn_per_block; ++i) {
      const CommandBlock block =
          DrawBlock(range_, DrawLength(std::min(rest, longest_block_)), random_);
      Blocks extended = *blocks;
      extended.push_back(block);
      // A run without derivatives costs a sixth.
      if (!IsKeptByFirst(1, extended, StampsOf(extended))) continue;
      const double worth = MeasureOf(extended);
      if (std::isfinite(worth)) drawn.emplace_back((worth - *value) / block.num_cells, block);
    }
    drawn.emplace_back(-std::numeric_limits<double>::infinity(),
                       CommandBlock{.kind = BlockKind::kStep,
                                    .num_cells = std::min(rest, longest_block_),
                                    .level = task_.holding_force});
    std::stable_sort(
        drawn.begin(), drawn.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    for (const auto& [gain, block] : drawn) {
      Blocks extended = *blocks;
      extended.push_back(block);
      if (!IsKeptByAll(WithRest(extended))) continue;
      if (std::isfinite(gain)) *value += gain * block.num_cells;
      *blocks = std::move(extended);
      return true;
    }
    return false;
  }

  int DrawPlace(std::size_t count) {
    return std::min(static_cast<int>(count) - 1,
                    static_cast<int>(random_.Uniform() * static_cast<double>(count)));
  }

  // Takes one change of the command if it is worth more. It costs little to see that a model breaks
  // a limit: another change takes its place.
  void TryChange(FoundCommand* found) {
    for (int trial = 0; trial < kMostTrialsOfChange; ++trial) {
      Blocks changed = Changed(found->blocks);
      if (!IsKeptByFirst(1, changed, stamps_and_after_)) continue;
      const double value = MeasureOf(changed);
      if (value > found->value && IsKeptByAll(changed)) {
        found->blocks = std::move(changed);
        found->value = value;
      }
      return;
    }
  }

  // The change of a command that is worth most, of the first that keep narrower limits. If none
  // does, the command before, where others keep it, or another one.
  FoundCommand UnderNarrowerLimits(const FoundCommand& found, const FoundCommand& before) {
    limits_.speed *= kNarrower;
    limits_.distance.low *= kNarrower;
    limits_.distance.high *= kNarrower;
    FoundCommand best;
    int num_kept = 0;
    for (int i = 0; i < kMostTrialsOfNarrowing && num_kept < kEnoughKept; ++i) {
      Blocks changed = Changed(found.blocks);
      if (!IsKeptByAll(changed)) continue;
      ++num_kept;
      const double value = MeasureOf(changed);
      if (value > best.value) best = {std::move(changed), value};
    }
    if (!best.blocks.empty()) return best;
    return IsKeptByOthers(before) ? before : Build();
  }

  Blocks Changed(Blocks blocks) {
    const int place = DrawPlace(blocks.size());
    CommandBlock& block = blocks[place];
    const double choice = random_.Uniform();
    if (choice < 0.3) {
      block = DrawBlock(range_, block.num_cells, random_);
    } else if (choice < 0.6) {
      ChangeLevel(&block);
    } else if (choice < 0.8) {
      MoveBorder(&blocks, place);
    } else if (choice < 0.9) {
      Split(&blocks, place);
    } else {
      std::swap(block, blocks[DrawPlace(blocks.size())]);
    }
    return blocks;
  }

  void ChangeLevel(CommandBlock* block) {
    const double step = kLevelStep * task_.limits.force;
    const double change = std::round(4.0 * random_.Normal()) * step;
    if (block->kind == BlockKind::kCoast) block->kind = BlockKind::kStep;
    const double least = block->kind == BlockKind::kStep ? -task_.limits.force : step;
    block->level = std::clamp(block->level + change, least, task_.limits.force);
    if (block->level == 0.0) block->kind = BlockKind::kCoast;
  }

  // Between the block and the next; one that keeps no cell is gone.
  void MoveBorder(Blocks* blocks, int place) {
    if (place + 1 >= std::ssize(*blocks)) return;
    CommandBlock& left = (*blocks)[place];
    CommandBlock& right = (*blocks)[place + 1];
    const int wanted = static_cast<int>(std::round(0.1 * longest_block_ * random_.Normal()));
    int change = wanted == 0 ? (random_.Uniform() < 0.5 ? -1 : 1) : wanted;
    change = std::clamp(change, -left.num_cells, right.num_cells);
    left.num_cells += change;
    right.num_cells -= change;
    std::erase_if(*blocks, [](const CommandBlock& block) { return block.num_cells == 0; });
  }

  // Puts a new block in place of the block's end.
  void Split(Blocks* blocks, int place) {
    CommandBlock& block = (*blocks)[place];
    if (block.num_cells < 2) return;
    const int length = DrawLength(block.num_cells - 1);
    block.num_cells -= length;
    const CommandBlock added = DrawBlock(range_, length, random_);
    blocks->insert(blocks->begin() + place + 1, added);
  }

  const CommandTask& task_;
  PlanLimits limits_;
  std::vector<ExtendedModel> models_;  // in the order in which they are asked
  RandomStream random_;
  int num_cells_ = 1;
  int longest_block_ = 1;
  BlockRange range_;
  std::vector<double> stamps_;
  std::vector<double> stamps_and_after_;
};

}  // namespace

FoundCommand SearchCommand(const CommandTask& task) {
  std::vector<FoundCommand> starts(static_cast<std::size_t>(task.num_starts));
  ParallelFor(task.num_starts, [&](int start) {
    CommandSearch search(task, start);
    FoundCommand& found = starts[static_cast<std::size_t>(start)];
    found = search.Build();
    if (!found.blocks.empty()) search.Improve(task.num_moves / task.num_starts, &found);
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
