// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#include "run_logs.h"

#include <chrono>
#include <exception>
#include <mutex>

#include "side_by_side.h"
#include <glog/logging.h>

namespace fathom::hidden {
namespace {

LogScore RunLog(const LogPlan& plan,
                std::uint64_t seed,
                OracleCache& oracle,
                const DiagnosisOptions& options) {
  const HiddenLog hidden = DrawHiddenLog(plan, seed);
  const OracleAnswer answer = oracle.Ask(hidden);
  const auto begin = std::chrono::steady_clock::now();
  // All that it gets to see.
  const Diagnosis diagnosis = Diagnose(std::span<const Log>(&hidden.log, 1), hidden.dof, options);
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
                              const DiagnosisOptions& options,
                              const std::function<void(const LogScore&)>& report) {
  std::vector<LogScore> scores(plans.size());
  std::mutex mutex;
  SideBySide(plans.size(), num_threads, [&](std::size_t i) {
    try {
      scores[i] = RunLog(plans[i], seed, oracle, options);
    } catch (const std::exception& error) {
      LOG(FATAL) << plans[i].Name() << ": " << error.what();
    }
    if (!report) return;
    const std::lock_guard<std::mutex> lock(mutex);
    report(scores[i]);
  });
  return scores;
}

}  // namespace fathom::hidden
