// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/base/parallel_for.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

namespace fathom {
namespace {

std::atomic<int> num_threads = 0;  // 0: as many as there are cores
thread_local bool is_within = false;

int NumThreads() {
  const int wanted = num_threads;
  return wanted > 0 ? wanted : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace

void SetNumThreads(int count) { num_threads = std::max(count, 1); }

void ParallelFor(int count, const std::function<void(int)>& work) {
  const int num_helpers = std::min(count, is_within ? 1 : NumThreads()) - 1;
  if (num_helpers <= 0) {
    for (int i = 0; i < count; ++i) work(i);
    return;
  }
  std::atomic<int> next = 0;
  std::vector<std::exception_ptr> failures(count);
  const auto run = [&] {
    is_within = true;
    for (int i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (...) {
        failures[i] = std::current_exception();
      }
    }
    is_within = false;
  };
  std::vector<std::thread> helpers;
  for (int i = 0; i < num_helpers; ++i) helpers.emplace_back(run);
  run();
  for (std::thread& helper : helpers) helper.join();
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

}  // namespace fathom
