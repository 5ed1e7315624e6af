// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The figures of docs/coupled.md on drawn vehicles in the plane with 0 to 4 couplings: which are
// named, what is named falsely, and how many intervals hold the truth: coupling_scores 40 [seed].

#include "fathom/base/interval95.h"
#include "fathom/coupled/structure_ladder.h"
#include "fathom/vehicle/coupled/entry_name.h"
#include "fathom/vehicle/coupled/entry_value.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "drawn_vehicle.h"
#include "side_by_side.h"
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fathom {
namespace {

constexpr int kThreads = 2;
constexpr double kClear = 5.0;  // standard deviations that a coupling has where all else is known

struct CoupledVehicle {
  CoupledModel model;
  std::vector<FreeEntry> couplings;
};

// Couplings of 10 to 35 % of what stands on the diagonal.
CoupledVehicle Drawn(std::size_t num_couplings, std::mt19937* random) {
  CoupledVehicle vehicle = {DrawnPlanarVehicle(random), {}};
  std::vector<FreeEntry> all;
  for (const Dof row : vehicle.model.dofs) {
    for (const Dof column : vehicle.model.dofs) {
      if (row < column) all.push_back(InertiaEntry(row, column));
      if (row != column) all.push_back(LinearDampingEntry(row, column));
    }
  }
  std::ranges::shuffle(all, *random);
  all.resize(num_couplings);
  for (const FreeEntry& entry : all) {
    const Matrix6& matrix = entry.kind == FreeEntry::Kind::kInertia ? vehicle.model.inertia
                                                                    : vehicle.model.linear_damping;
    const int i = Index(entry.row), j = Index(entry.column);
    const double share = std::uniform_real_distribution<double>(0.10, 0.35)(*random);
    const double sign = std::bernoulli_distribution(0.5)(*random) ? 1.0 : -1.0;
    SetValue(entry, sign * share * std::sqrt(matrix(i, i) * matrix(j, j)), &vehicle.model);
  }
  vehicle.couplings = all;
  return vehicle;
}

struct Score {
  std::vector<std::string> named, clear, drawn;
  int num_numbers = 0, num_covered = 0;
  bool is_physical = true;
};

Score ScoreOf(unsigned seed) {
  std::mt19937 random(seed);
  const CoupledVehicle vehicle = Drawn(seed % 5, &random);
  CoupledLogs logs;
  logs.data = {DrawnLog(vehicle.model, {}, &random)};
  logs.data[0].has_attitude = true;
  MotionStructure truth = StructureOf(StandardStructure::kCoriolis, vehicle.model.dofs);
  truth.entries.insert(truth.entries.end(), vehicle.couplings.begin(), vehicle.couplings.end());
  const CoupledSummary oracle = FitBlocks(logs, truth, {});
  Score score;
  for (const FreeEntry& entry : vehicle.couplings) {
    score.drawn.push_back(NameOf(entry));
    if (std::abs(ValueIn(vehicle.model, entry)) > kClear * StdOf(oracle, entry)) {
      score.clear.push_back(NameOf(entry));
    }
  }
  const Ladder ladder = ClimbLadder(logs, vehicle.model.dofs, {});
  for (const NamedEntry& named : ladder.named) score.named.push_back(NameOf(named.entry));
  const CoupledSummary& fit = ladder.rungs[ladder.accepted].fit;
  for (const FreeEntry& entry : fit.entries) {
    const double miss = ValueIn(fit.model, entry) - ValueIn(vehicle.model, entry);
    ++score.num_numbers;
    if (std::abs(miss) < kStdsOf95 * StdOf(fit, entry)) ++score.num_covered;
  }
  score.is_physical = IsPositiveDefinite(fit.model.inertia, fit.model.dofs) && IsPassive(fit.model);
  return score;
}

bool Holds(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::count(names, name) > 0;
}

void PrintScores(std::size_t count, unsigned first) {
  std::vector<Score> scores(count);
  SideBySide(count, kThreads, [&](std::size_t k) {
    scores[k] = ScoreOf(first + static_cast<unsigned>(k));
    fmt::print("  {}: {} of {}\n",
               first + k,
               fmt::join(scores[k].named, ", "),
               fmt::join(scores[k].drawn, ", "));
    std::fflush(stdout);
  });
  int num_clear = 0, num_named = 0, num_false = 0, num_numbers = 0, num_covered = 0;
  bool all_physical = true;
  for (const Score& score : scores) {
    num_clear += static_cast<int>(score.clear.size());
    for (const std::string& name : score.clear) num_named += Holds(score.named, name) ? 1 : 0;
    const auto is_false = [&](const std::string& name) { return !Holds(score.drawn, name); };
    if (std::ranges::any_of(score.named, is_false)) ++num_false;
    num_numbers += score.num_numbers;
    num_covered += score.num_covered;
    all_physical = all_physical && score.is_physical;
  }
  fmt::print("named: {} of {} clear couplings; something false on {} of {} vehicles\n",
             num_named,
             num_clear,
             num_false,
             count);
  fmt::print("intervals of 95 %: {} of {} numbers covered; all models of bodies: {}\n",
             num_covered,
             num_numbers,
             all_physical);
}

}  // namespace
}  // namespace fathom

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: coupling_scores COUNT [FIRST_SEED]\n");
    return 1;
  }
  fathom::PrintScores(std::strtoul(argv[1], nullptr, 10),
                      argc > 2 ? static_cast<unsigned>(std::strtoul(argv[2], nullptr, 10)) : 1);
  return 0;
}
