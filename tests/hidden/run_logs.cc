// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "run_logs.h"

#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>

#include <glog/logging.h>

namespace fathom::hidden {
namespace {

LogScore RunLog(const LogPlan& plan, std::uint64_t seed, OracleCache& oracle) {
  const HiddenLog hidden = DrawHiddenLog(plan, seed);
  const OracleAnswer answer = oracle.Ask(hidden);
  const auto begin = std::chrono::steady_clock::now();
  // All that it gets to see.
  const Diagnosis diagnosis = Diagnose(std::span<const Log>(&hidden.log, 1), hidden.dof);
  const auto end = std::chrono::steady_clock::now();
  CHECK(diagnosis.IsUsable()) << diagnosis.message;
  LogScore score = ScoreOf(hidden, answer, diagnosis);
  score.seconds = std::chrono::duration<double>(end - begin).count();
  return score;
}

}  // namespace

std::vector<LogScore> RunLogs(const std::vector<LogPlan>& plans,
                              std::uint64_t seed,
                              int num_threads,
                              OracleCache& oracle,
                              const std::function<void(const LogScore&)>& report) {
  std::vector<LogScore> scores(plans.size());
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  const auto work = [&] {
    for (std::size_t i = next++; i < plans.size(); i = next++) {
      try {
        scores[i] = RunLog(plans[i], seed, oracle);
      } catch (const std::exception& error) {
        LOG(FATAL) << plans[i].Name() << ": " << error.what();
      }
      if (!report) continue;
      const std::lock_guard<std::mutex> lock(mutex);
      report(scores[i]);
    }
  };
  std::vector<std::thread> threads;
  for (int k = 1; k < num_threads; ++k) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  return scores;
}

}  // namespace fathom::hidden
