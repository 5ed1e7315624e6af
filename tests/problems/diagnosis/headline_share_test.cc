// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

// The share of the error that the first sentence of a diagnosis names, against the share that the
// true model removes from the motion without noise.

#include "fathom/diagnosis/data/measured_segments.h"
#include "fathom/diagnosis/diagnosis.h"
#include "fathom/diagnosis/measures/held_out.h"
#include "fathom/diagnosis/report/verdict_sentence.h"
#include "fathom/vehicle/effects/catalogue.h"

#include <cstddef>
#include <vector>

#include "surge_run.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace fathom {
namespace {

using ::testing::StartsWith;

constexpr double kWidth = 8.0;  // of the dead zone [N]

struct Hidden {
  double turbulence = 0.0;  // [N]: the part of the error that no cause explains
  bool has_poses = false;
  double share_near = 0.0;  // what the true share is about
};

SurgeRun RunWith(const Hidden& hidden) {
  SurgeRun run;
  run.input = Multisine(30.0);
  run.duration = 1200.0;
  run.turbulence = hidden.turbulence;
  run.has_poses = hidden.has_poses;
  run.effects = fmt::format("thrust_dead_zone:width={}", kWidth);
  return run;
}

Log WithHeldOut(Log log) {
  log.held_out = {{.from = 600.0, .to = 1200.0}};
  return log;
}

// How much of the squared error of `users` another model removes on the held-out data of a log
// without noise.
double RemovedShare(const Log& clean, const ExtendedModel& users, const ExtendedModel& other) {
  const std::vector<Log> logs = {clean};
  double before = 0.0, after = 0.0;
  for (const MeasuredSegment& segment : MeasuredSegmentsOf(logs, Dof::kSurge).all) {
    if (!segment.is_held_out) continue;
    const auto of_users = FreeRunOver(segment, users), of_other = FreeRunOver(segment, other);
    for (std::size_t i = 0; i < of_users->time.size(); ++i) {
      const double miss = of_users->predicted[i] - of_users->measured[i];
      const double left = of_other->predicted[i] - of_other->measured[i];
      before += miss * miss;
      after += left * left;
    }
  }
  return 1.0 - after / before;
}

class HeadlineShare : public ::testing::TestWithParam<Hidden> {};

TEST_P(HeadlineShare, IsTheShareThatTheTrueModelRemoves) {
  const Hidden& hidden = GetParam();
  SurgeRun run = RunWith(hidden);
  const std::vector<Log> logs = {WithHeldOut(LogOf(run, 3))};
  const Diagnosis diagnosis = Diagnose(logs, Dof::kSurge);
  ASSERT_EQ(diagnosis.causes.size(), 1u) << VerdictSentence(diagnosis);

  run.velocity_noise = 1e-9;
  run.position_noise = 1e-9;
  const Log clean = WithHeldOut(LogOf(run, 3));
  const ExtendedModel& users = diagnosis.baseline.model;
  const ExtendedModel truth = {kSurgeTruth,
                               {{FindEffect("thrust_dead_zone"), {.dof = Dof::kSurge}, {kWidth}}}};
  const double share = diagnosis.explained_share, true_share = RemovedShare(clean, users, truth);
  EXPECT_NEAR(true_share, hidden.share_near, 0.1);
  EXPECT_NEAR(share, true_share, 0.1);
  EXPECT_THAT(VerdictSentence(diagnosis),
              StartsWith(fmt::format(
                  "{:.0f} % of the error of your surge model that is not noise comes from",
                  100.0 * share)));
}

INSTANTIATE_TEST_SUITE_P(OfOneAndTwoSources,
                         HeadlineShare,
                         ::testing::Values(Hidden{2.6, false, 0.2},
                                           Hidden{1.3, false, 0.5},
                                           Hidden{0.43, false, 0.9},
                                           Hidden{2.6, true, 0.2},
                                           Hidden{1.3, true, 0.5},
                                           Hidden{0.43, true, 0.9}),
                         [](const auto& info) {
                           return fmt::format("{}of{}",
                                              info.param.has_poses ? "Two" : "One",
                                              static_cast<int>(100.0 * info.param.share_near));
                         });

}  // namespace
}  // namespace fathom
