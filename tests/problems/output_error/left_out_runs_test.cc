// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/output_error/left_out_runs.h"

#include <cstddef>
#include <set>
#include <span>
#include <vector>

#include "synthetic_run.h"
#include <gtest/gtest.h>

namespace fathom {
namespace {

const UncoupledModel<double> kTruth = SyntheticRun{}.truth;
const UncoupledModel<double> kHeavier = {
    1.3 * kTruth.inertia, kTruth.quadratic_damping, kTruth.linear_damping, kTruth.buoyancy};

// Runs of the truth that start a thousand seconds apart.
std::vector<Segment> Runs(int count) {
  std::vector<Segment> runs;
  for (int k = 0; k < count; ++k) {
    SyntheticRun run = {.command = Multisine};
    run.duration = 60.0;
    run.start = 1000.0 * k;
    run.noise = 0.01;
    runs.push_back(Synthesize(run, static_cast<unsigned>(k)));
  }
  return runs;
}

OutputErrorSummary Fitted(const UncoupledModel<double>& model,
                          Weighting weighting,
                          std::size_t num_segments) {
  OutputErrorSummary summary;
  summary.converged = true;
  summary.weighting = weighting;
  summary.model = model;
  summary.offsets = {{.value = model.buoyancy}};
  summary.initial_states.resize(num_segments);
  return summary;
}

std::optional<double> More(const std::vector<Segment>& runs,
                           const UncoupledModel<double>& by_plain,
                           const UncoupledModel<double>& by_learned) {
  return MoreMissedOfLeftOutRuns(
      runs,
      {},
      Fitted(by_plain, Weighting::kPlain, runs.size()),
      [&](std::span<const std::size_t> kept, Weighting weighting) {
        return Fitted(
            weighting == Weighting::kPlain ? by_plain : by_learned, weighting, kept.size());
      });
}

TEST(MoreMissedOfLeftOutRuns, IsAboveZeroWhereLearnedWeightsMoveTheModelFromTheTruth) {
  EXPECT_GT(More(Runs(2), kTruth, kHeavier), 0.1);
  EXPECT_GT(More(Runs(3), kTruth, kHeavier), 0.1);
  EXPECT_LT(More(Runs(3), kHeavier, kTruth), -0.1);
  EXPECT_EQ(More(Runs(3), kTruth, kTruth), 0.0);
}

TEST(MoreMissedOfLeftOutRuns, IsUnknownOfOneRun) {
  EXPECT_FALSE(More(Runs(1), kTruth, kHeavier).has_value());
}

TEST(MoreMissedOfLeftOutRuns, LeavesEachRunOutOnce) {
  const std::vector<Segment> runs = Runs(6);
  std::vector<std::set<double>> fitted;  // where the segments of each fit start [s]
  MoreMissedOfLeftOutRuns(runs,
                          {},
                          Fitted(kTruth, Weighting::kPlain, runs.size()),
                          [&](std::span<const std::size_t> kept, Weighting weighting) {
                            std::set<double> starts;
                            for (const std::size_t s : kept) starts.insert(runs[s].time.front());
                            if (weighting == Weighting::kPlain) fitted.push_back(starts);
                            return Fitted(kTruth, weighting, kept.size());
                          });
  ASSERT_EQ(fitted.size(), 4U);
  for (const Segment& run : runs) {
    std::size_t times = 0;
    for (const auto& starts : fitted) times += starts.contains(run.time.front()) ? 0U : 1U;
    EXPECT_EQ(times, 1U) << run.time.front();
  }
}

}  // namespace
}  // namespace fathom
