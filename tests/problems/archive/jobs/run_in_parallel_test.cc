// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/jobs/run_in_parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace fathom {
namespace {

// `count` jobs without followers, each of which calls `work` with its number.
std::vector<Job> Jobs(std::size_t count, std::function<void(std::size_t)> work) {
  std::vector<Job> jobs;
  for (std::size_t i = 0; i < count; ++i) {
    jobs.push_back({[work, i] {
      work(i);
      return std::vector<Job>();
    }});
  }
  return jobs;
}

TEST(RunInParallel, CallsEachJobOnce) {
  for (const int at_a_time : {1, 3, 200}) {
    std::vector<std::atomic<int>> calls(100);
    RunInParallel(at_a_time, Jobs(calls.size(), [&](std::size_t i) { ++calls[i]; }));
    for (const auto& count : calls) EXPECT_EQ(count, 1);
  }
  RunInParallel(2, {});
}

TEST(RunInParallel, RunsSoManyAtATime) {
  std::atomic<int> running = 0, most = 0;
  RunInParallel(3, Jobs(12, [&](std::size_t) {
                  const int now = ++running;
                  for (int known = most; known < now && !most.compare_exchange_weak(known, now);) {
                  }
                  std::this_thread::sleep_for(std::chrono::milliseconds(20));
                  --running;
                }));
  EXPECT_LE(most, 3);
  EXPECT_GE(most, 2);
}

TEST(RunInParallel, IsInOrderOneAtATime) {
  std::vector<std::size_t> order;
  RunInParallel(1, Jobs(20, [&](std::size_t i) { order.push_back(i); }));
  EXPECT_EQ(order.size(), 20u);
  EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
}

TEST(RunInParallel, RunsWhatFollowsBeforeWhatWaits) {
  std::vector<std::size_t> order;
  const auto note = [&](std::size_t i) { order.push_back(i); };
  std::vector<Job> jobs = Jobs(1, note);
  jobs.push_back({[&] {
    note(1);
    std::vector<Job> followers = Jobs(4, note);
    followers.erase(followers.begin(), followers.begin() + 2);
    return followers;
  }});
  jobs.push_back({[&] {
    note(4);
    return std::vector<Job>();
  }});
  RunInParallel(1, std::move(jobs));
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
}

// The second thread has nothing to do until the only job is through, and then takes one of two that
// wait for each other.
TEST(RunInParallel, GivesWhatFollowsToThreadsThatWaited) {
  std::atomic<int> begun = 0;
  const auto meet = [&](std::size_t) {
    ++begun;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (begun < 2 && std::chrono::steady_clock::now() < end) std::this_thread::yield();
    EXPECT_EQ(begun, 2);
  };
  RunInParallel(2, {{[&] { return Jobs(2, meet); }}});
}

TEST(RunInParallel, EndsTheRestAndThrowsOnWhatAJobThrows) {
  std::atomic<int> calls = 0;
  EXPECT_THROW(RunInParallel(1,
                             Jobs(1000,
                                  [&](std::size_t i) {
                                    ++calls;
                                    if (i == 10) throw std::runtime_error("x");
                                  })),
               std::runtime_error);
  EXPECT_EQ(calls, 11);
}

}  // namespace
}  // namespace fathom
