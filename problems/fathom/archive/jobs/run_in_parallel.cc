// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fathom/archive/jobs/run_in_parallel.h"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <exception>
#include <iterator>
#include <mutex>
#include <thread>
#include <utility>

namespace fathom {
namespace {

// What the threads share.
struct Queue {
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<Job> waiting;
  int num_running = 0;
  std::exception_ptr failure;
};

// Runs jobs until none waits and none runs that others may follow from.
void WorkThrough(Queue* queue) {
  std::unique_lock lock(queue->mutex);
  while (true) {
    queue->changed.wait(lock, [&] { return !queue->waiting.empty() || queue->num_running == 0; });
    if (queue->waiting.empty()) return;
    Job job = std::move(queue->waiting.front());
    queue->waiting.pop_front();
    ++queue->num_running;
    lock.unlock();
    std::vector<Job> followers;
    std::exception_ptr failure;
    try {
      followers = job.run();
    } catch (...) {
      failure = std::current_exception();
    }
    job = {};
    lock.lock();
    --queue->num_running;
    if (failure && !queue->failure) queue->failure = failure;
    if (queue->failure) {
      queue->waiting.clear();
    } else {
      queue->waiting.insert(queue->waiting.begin(),
                            std::make_move_iterator(followers.begin()),
                            std::make_move_iterator(followers.end()));
    }
    queue->changed.notify_all();
  }
}

}  // namespace

void RunInParallel(int at_a_time, std::vector<Job> jobs) {
  Queue queue;
  std::ranges::move(jobs, std::back_inserter(queue.waiting));
  std::vector<std::thread> threads;
  for (int i = 0; i < std::max(at_a_time, 1); ++i) threads.emplace_back(WorkThrough, &queue);
  for (std::thread& thread : threads) thread.join();
  if (queue.failure) std::rethrow_exception(queue.failure);
}

}  // namespace fathom
