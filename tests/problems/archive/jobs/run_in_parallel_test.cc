// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/jobs/run_in_parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

TEST(RunInParallel, CallsEachJobOnce) {
  for (const int at_a_time : {1, 3, 200}) {
    std::vector<std::atomic<int>> calls(100);
    RunInParallel(at_a_time, calls.size(), [&](std::size_t i) { ++calls[i]; });
    for (const auto& count : calls) EXPECT_EQ(count, 1);
  }
  RunInParallel(2, 0, [](std::size_t) { FAIL(); });
}

TEST(RunInParallel, RunsSoManyAtATime) {
  std::atomic<int> running = 0, most = 0;
  RunInParallel(3, 12, [&](std::size_t) {
    const int now = ++running;
    for (int known = most; known < now && !most.compare_exchange_weak(known, now);) {
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    --running;
  });
  EXPECT_LE(most, 3);
  EXPECT_GE(most, 2);
}

TEST(RunInParallel, IsInOrderOneAtATime) {
  std::vector<std::size_t> order;
  RunInParallel(1, 20, [&](std::size_t i) { order.push_back(i); });
  EXPECT_EQ(order.size(), 20u);
  EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
}

TEST(RunInParallel, EndsTheRestAndThrowsOnWhatAJobThrows) {
  std::atomic<int> calls = 0;
  EXPECT_THROW(RunInParallel(1,
                             1000,
                             [&](std::size_t i) {
                               ++calls;
                               if (i == 10) throw std::runtime_error("x");
                             }),
               std::runtime_error);
  EXPECT_EQ(calls, 11);
}

}  // namespace
}  // namespace fathom
