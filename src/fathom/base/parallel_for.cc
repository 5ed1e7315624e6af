// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/parallel_for.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

namespace fathom {
namespace {

std::atomic<int> num_threads = 0;  // 0: as many as there are cores
std::atomic<int> num_at_work = 0;  // those that run, not those that wait for others
thread_local bool is_at_work = false;

int NumThreads() {
  const int wanted = num_threads;
  return wanted > 0 ? wanted : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

// Of the threads that are not at work, as many as are wanted and there are.
int TakeIdle(int wanted) {
  int at_work = num_at_work;
  for (;;) {
    const int taken = std::max(0, std::min(wanted, NumThreads() - at_work));
    if (num_at_work.compare_exchange_weak(at_work, at_work + taken)) return taken;
  }
}

}  // namespace

void SetNumThreads(int count) { num_threads = std::max(count, 1); }

void ParallelFor(int count, const std::function<void(int)>& work) {
  const bool is_outermost = !is_at_work;
  if (is_outermost) ++num_at_work;
  is_at_work = true;
  std::atomic<int> next = 0;
  std::vector<std::exception_ptr> failures(count);
  const auto run = [&] {
    for (int i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (...) {
        failures[i] = std::current_exception();
      }
    }
  };
  std::vector<std::thread> helpers(TakeIdle(count - 1));
  // The place of the last one to end is this thread's when it goes on.
  std::atomic<std::size_t> num_left = helpers.size() + 1;
  const auto leave = [&] {
    if (--num_left > 0) --num_at_work;
  };
  for (std::thread& helper : helpers) {
    helper = std::thread([&] {
      is_at_work = true;
      run();
      leave();
    });
  }
  run();
  leave();
  for (std::thread& helper : helpers) helper.join();
  if (is_outermost) --num_at_work;
  is_at_work = !is_outermost;
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

}  // namespace fathom
