// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/findings/values/stuck_values.h"

#include "fathom/findings/values/large_jump.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace fathom {
namespace {

constexpr double kShortestStuck = 1.0;  // [s]
constexpr std::size_t kFewestStuckRows = 5;
constexpr double kShortestWithoutJump = 5.0;  // [s]
constexpr double kFewEqual = 0.05;            // of the steps

// How the values go on outside long runs.
struct UsualSteps {
  double jump = 0.0;         // LargeJump() of those that are not 0
  double mean = 0.0;         // of those that are not 0
  double equal_share = 0.0;  // of those that are 0
};

bool IsLong(std::span<const double> time, const EqualRun& run) {
  return run.NumRows() >= kFewestStuckRows && time[run.last] - time[run.first] >= kShortestStuck;
}

UsualSteps UsualStepsOf(std::span<const double> time,
                        std::span<const double> values,
                        const std::vector<EqualRun>& runs) {
  std::vector<double> changes;
  std::size_t num_equal = 0;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (k > 0) changes.push_back(std::abs(values[runs[k].first] - values[runs[k - 1].first]));
    if (!IsLong(time, runs[k])) num_equal += runs[k].NumRows() - 1;
  }
  if (changes.empty()) return {};
  const auto num_steps = static_cast<double>(changes.size() + num_equal);
  const double mean =
      std::accumulate(changes.begin(), changes.end(), 0.0) / static_cast<double>(changes.size());
  return {.jump = LargeJump(std::move(changes)),
          .mean = mean,
          .equal_share = static_cast<double>(num_equal) / num_steps};
}

// Whether the values come to rest in a run, as those of a vehicle without noise do, or leave it
// from rest where it is the first: some steps next to it are far smaller than the usual ones.
bool ComesToRest(std::span<const double> values, const EqualRun& run, const UsualSteps& usual) {
  constexpr std::size_t kNumSteps = 5;
  constexpr double kSmall = 0.1;
  const bool is_first = run.first == 0;
  const std::size_t begin = is_first ? run.last : run.first - std::min(run.first, kNumSteps);
  const std::size_t end = is_first ? std::min(run.last + kNumSteps, values.size() - 1) : run.first;
  if (end - begin < kNumSteps) return false;
  for (std::size_t i = begin; i < end; ++i) {
    if (std::abs(values[i + 1] - values[i]) > kSmall * usual.mean) return false;
  }
  return true;
}

}  // namespace

std::optional<StuckValues> FindStuckValues(std::span<const double> time,
                                           std::span<const double> values) {
  const std::vector<EqualRun> runs = EqualRunsOf(values);
  const UsualSteps usual = UsualStepsOf(time, values, runs);
  if (!(usual.jump > 0.0)) return std::nullopt;
  StuckValues stuck;
  for (const EqualRun& run : runs) {
    if (!IsLong(time, run)) continue;
    const double value = values[run.first];
    const double jump_in = run.first > 0 ? std::abs(value - values[run.first - 1]) : 0.0;
    const double jump_out =
        run.last + 1 < values.size() ? std::abs(value - values[run.last + 1]) : 0.0;
    const bool jumps = std::max(jump_in, jump_out) > usual.jump;
    const bool never_rests = value != 0.0 && usual.equal_share < kFewEqual &&
                             time[run.last] - time[run.first] >= kShortestWithoutJump;
    if ((!jumps && !never_rests) || ComesToRest(values, run, usual)) continue;
    if (run.NumRows() > (stuck.num_rows == 0 ? 0 : stuck.longest.NumRows())) stuck.longest = run;
    stuck.num_rows += run.NumRows();
  }
  if (stuck.num_rows == 0) return std::nullopt;
  return stuck;
}

}  // namespace fathom
