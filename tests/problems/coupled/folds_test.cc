// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/coupled/folds.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

// Logs of 100 s at 10 Hz.
std::vector<CoupledData> Logs(int num) {
  std::vector<CoupledData> logs(num);
  for (int k = 0; k < num; ++k) {
    logs[k].log = std::to_string(k);
    CoupledSegment& segment = logs[k].segments.emplace_back();
    for (int i = 0; i <= 1000; ++i) segment.time.push_back(0.1 * i);
    segment.velocity.assign(segment.time.size(), Vector6::Zero());
  }
  return logs;
}

double DurationOf(const std::vector<CoupledData>& logs) {
  double sum = 0.0;
  for (const CoupledData& log : logs) {
    for (const CoupledSegment& segment : log.segments) {
      sum += segment.time.back() - segment.time.front();
    }
  }
  return sum;
}

TEST(Folds, OfTwoLogsTrainOnThreeQuartersOfEach) {
  const std::vector<CoupledData> logs = Logs(2);
  const std::vector<Fold> folds = FoldsOf(logs);
  ASSERT_EQ(folds.size(), 4);
  for (const Fold& fold : folds) {
    ASSERT_EQ(fold.train.size(), 2);
    ASSERT_EQ(fold.unseen.size(), 2);
    EXPECT_NEAR(DurationOf(fold.train), 150.0, 1.0);
    EXPECT_NEAR(DurationOf(fold.unseen), 50.0, 1.0);
  }
}

TEST(Folds, OfFourLogsLeaveOutOneEach) {
  const std::vector<CoupledData> logs = Logs(4);
  const std::vector<Fold> folds = FoldsOf(logs);
  ASSERT_EQ(folds.size(), 4);
  for (std::size_t f = 0; f < 4; ++f) {
    ASSERT_EQ(folds[f].unseen.size(), 1);
    EXPECT_EQ(folds[f].unseen.front().log, logs[f].log);
    EXPECT_EQ(folds[f].train.size(), 3);
  }
}

}  // namespace
}  // namespace fathom
