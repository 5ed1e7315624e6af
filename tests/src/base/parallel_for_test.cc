// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/parallel_for.h"

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

class ParallelForOn : public ::testing::TestWithParam<int> {
 protected:
  void SetUp() override { SetNumThreads(GetParam()); }
};

TEST_P(ParallelForOn, CallsEachIndexOnce) {
  std::vector<std::atomic<int>> calls(1000);
  ParallelFor(1000, [&](int i) { ++calls[i]; });
  for (const auto& count : calls) EXPECT_EQ(count, 1);
  ParallelFor(0, [](int) { FAIL(); });
}

TEST_P(ParallelForOn, MayBeCalledWithinItself) {
  std::vector<std::atomic<int>> sums(8);
  ParallelFor(8, [&](int i) { ParallelFor(10, [&](int k) { sums[i] += k; }); });
  for (const auto& sum : sums) EXPECT_EQ(sum, 45);
}

TEST_P(ParallelForOn, RethrowsTheFailureOfTheLowestIndex) {
  std::string what;
  try {
    ParallelFor(100, [](int i) {
      if (i >= 7) throw std::runtime_error(std::to_string(i));
    });
  } catch (const std::runtime_error& error) {
    what = error.what();
  }
  EXPECT_EQ(what, "7");
}

INSTANTIATE_TEST_SUITE_P(Threads, ParallelForOn, ::testing::Values(1, 2, 5));

// Both calls wait for each other: with one thread they never would.
TEST(ParallelFor, RunsSeveralAtOnce) {
  SetNumThreads(2);
  std::atomic<int> arrived = 0;
  ParallelFor(2, [&](int) {
    ++arrived;
    while (arrived < 2) std::this_thread::yield();
  });
  EXPECT_EQ(arrived, 2);
}

// The one that is left over runs on both threads, once the other has nothing to do.
TEST(ParallelFor, WithinItselfTakesThreadsThatAreIdle) {
  SetNumThreads(2);
  std::atomic<int> done = 0, arrived = 0;
  ParallelFor(2, [&](int i) {
    if (i == 0) {
      ++done;
      return;
    }
    while (done < 1) std::this_thread::yield();
    // The other thread ends a moment after it has done its part.
    while (arrived < 2) {
      std::atomic<int> at_once = 0;
      ParallelFor(2, [&](int) {
        const int count = ++at_once;
        for (int k = 0; k < 1000 && at_once < 2; ++k) std::this_thread::yield();
        if (count == 2) arrived = 2;
      });
    }
  });
  EXPECT_EQ(arrived, 2);
}

TEST(ParallelFor, RunsNoMoreAtOnceThanThereAreThreads) {
  SetNumThreads(3);
  std::atomic<int> running = 0, most = 0;
  ParallelFor(8, [&](int) {
    ParallelFor(8, [&](int) {
      const int now = ++running;
      for (int seen = most; now > seen && !most.compare_exchange_weak(seen, now);) continue;
      const auto begin = std::chrono::steady_clock::now();
      do {
        std::this_thread::yield();
      } while (most < 2 && std::chrono::steady_clock::now() - begin < std::chrono::seconds(5));
      --running;
    });
  });
  EXPECT_LE(most, 3);
  EXPECT_GE(most, 2);
}

}  // namespace
}  // namespace fathom
