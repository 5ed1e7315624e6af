// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/ladder.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "drawn_vehicle.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fathom {
namespace {

// Off the diagonal, of a size that shows: 5 to 30 % of the geometric mean of the two diagonal
// entries, drawn among the couplings that a vehicle with two sides alike may have, and others.
std::vector<FreeEntry> AddCouplings(int num, CoupledModel* model, std::mt19937* random) {
  std::vector<FreeEntry> all;
  for (const Dof row : model->dofs) {
    for (const Dof column : model->dofs) {
      if (row == column) continue;
      if (row < column) all.push_back(InertiaEntry(row, column));
      all.push_back(LinearDampingEntry(row, column));
    }
  }
  std::shuffle(all.begin(), all.end(), *random);
  all.resize(static_cast<std::size_t>(num));
  for (const FreeEntry& entry : all) {
    const Matrix6& matrix =
        entry.kind == FreeEntry::Kind::kInertia ? model->inertia : model->linear_damping;
    const int i = Index(entry.row), j = Index(entry.column);
    const double mean = std::sqrt(matrix(i, i) * matrix(j, j));
    const double share = std::uniform_real_distribution<double>(0.1, 0.35)(*random);
    SetValue(entry,
             (std::uniform_int_distribution<int>(0, 1)(*random) ? 1.0 : -1.0) * share * mean,
             model);
  }
  return all;
}

TEST(ClimbLadder, Drawn) {
  const int first = std::atoi(getenv("FIRST") ? getenv("FIRST") : "0");
  const int last = std::atoi(getenv("LAST") ? getenv("LAST") : "4");
  for (int seed = first; seed < last; ++seed) {
    std::mt19937 random(1000 + seed);
    CoupledModel truth = DrawnPlanarVehicle(&random);
    truth.coriolis = seed % 2 == 0;
    const std::vector<FreeEntry> hidden = AddCouplings(seed % 5, &truth, &random);
    CoupledLogs logs;
    logs.data = {DrawnLog(truth, {}, &random)};
    const Ladder ladder = ClimbLadder(logs, truth.dofs, {});
    std::printf("%d C %d accepted %s C %d hidden:",
                seed,
                truth.coriolis,
                ladder.rungs[ladder.accepted].name.c_str(),
                ladder.rungs[ladder.accepted].structure.coriolis);
    for (const FreeEntry& entry : hidden)
      std::printf(" %s=%.3g", NameOf(entry).c_str(), ValueIn(truth, entry));
    std::printf(" | named:");
    for (const NamedEntry& named : ladder.named) {
      const bool is_right = std::find(hidden.begin(), hidden.end(), named.entry) != hidden.end();
      std::printf(" %s%s=%.3g+-%.2g",
                  is_right ? "" : "FALSE ",
                  NameOf(named.entry).c_str(),
                  named.value,
                  named.std);
    }
    std::printf(" |");
    for (const auto& rung : ladder.rungs)
      std::printf(" %s %.1f", rung.name.c_str(), rung.gain_in_errors);
    std::printf("\n");
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace fathom
