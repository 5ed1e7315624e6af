// SPDX-FileCopyrightText: 2026 The Fathom authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdio>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <benchmark/benchmark.h>

namespace fathom {

inline constexpr double kNoLimit = std::numeric_limits<double>::infinity();

// Keeps the best CPU time of each benchmark.
class BestTimes : public benchmark::ConsoleReporter {
 public:
  BestTimes() : ConsoleReporter(OO_Tabular) {}

  // All repetitions of one benchmark, of which the best is shown.
  void ReportRuns(const std::vector<Run>& runs) override {
    const Run* best = nullptr;
    for (const Run& run : runs) {
      has_failed_ = has_failed_ || run.error_occurred;
      if (run.run_type != Run::RT_Iteration) continue;
      if (!best || run.GetAdjustedCPUTime() < best->GetAdjustedCPUTime()) best = &run;
    }
    if (!best) return;
    ConsoleReporter::ReportRuns({*best});
    const auto& [name, args] = std::tie(best->run_name.function_name, best->run_name.args);
    if (!has_failed_) best_[args.empty() ? name : name + "/" + args] = best->GetAdjustedCPUTime();
  }

  // Prints the ratio of two times. False if it is above `limit`; one that was not measured (as with
  // --benchmark_filter) breaks none.
  bool PrintRatio(const std::string& above, const std::string& below, double limit) const {
    if (!best_.count(above) || !best_.count(below)) return true;
    const double ratio = best_.at(above) / best_.at(below);
    const bool is_kept = ratio <= limit;
    std::printf("%-36s %6.2f", (above + " / " + below).c_str(), ratio);
    if (limit < kNoLimit) std::printf("  %s %g", is_kept ? "at most" : "BROKEN: at most", limit);
    std::printf("\n");
    return is_kept;
  }

  // Prints a time [ms]. False if it is above `limit`.
  bool PrintTime(const std::string& name, double limit) const {
    if (!best_.count(name)) return true;
    const bool is_kept = best_.at(name) <= limit;
    std::printf("%-36s %6.0f ms  %s %g\n",
                name.c_str(),
                best_.at(name),
                is_kept ? "at most" : "BROKEN: at most",
                limit);
    return is_kept;
  }

  bool has_failed() const { return has_failed_; }

 private:
  std::map<std::string, double> best_;  // [ms]
  bool has_failed_ = false;
};

// Runs the benchmarks that the command line asks for. Repetitions are in random order: what else
// the machine does then meets all benchmarks alike.
inline void RunBenchmarks(int argc, char** argv, BestTimes* times) {
  std::string interleave = "--benchmark_enable_random_interleaving=true";
  std::vector<char*> arguments(argv, argv + argc);
  arguments.insert(arguments.begin() + 1, interleave.data());
  int num_arguments = argc + 1;
  benchmark::Initialize(&num_arguments, arguments.data());
  benchmark::RunSpecifiedBenchmarks(times);
}

}  // namespace fathom
